# Fails when the core of the ray tracer can no longer be read in one sitting: rays from the eye, traversal, shading,
# recursion, sampling; without shapes and accelerators. Lines that are blank or a comment do not count.
#   cmake -D ROOT=<folder of the project> -P tests/tracer_core_size.cmake

cmake_minimum_required(VERSION 3.25)

set(most_lines 600)
set(core ray.hpp viewing.hpp viewing.cpp ray_tracer.hpp ray_tracer.cpp sampling.hpp sampling.cpp render.hpp render.cpp)

set(count 0)
foreach(file IN LISTS core)
  file(READ ${ROOT}/reference/ray_tracer/${file} text)
  # CMake's lists may not hold semicolons and brackets.
  string(REGEX REPLACE "[][;]" "," text "\n${text}")
  string(REGEX MATCHALL "\n[ \t]*([^ \t\n/]|/[^/\n])" starts "${text}")
  list(LENGTH starts lines)
  if(lines EQUAL 0)
    message(FATAL_ERROR "reference/ray_tracer/${file} is empty")
  endif()
  math(EXPR count "${count} + ${lines}")
endforeach()

if(count GREATER most_lines)
  message(FATAL_ERROR "the core of the ray tracer has ${count} lines of code, ${most_lines} can be read in one sitting")
endif()
message("the core of the ray tracer has ${count} lines of code")
