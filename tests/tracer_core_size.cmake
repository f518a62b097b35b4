# Fails when the core of the ray tracer can no longer be read in one sitting: rays from the eye, what they meet, shading,
# shadows, recursion; and, a subject of its own, sampling. Without shapes, accelerators, materials and lights. Lines that are
# blank or a comment do not count.
#   cmake -D ROOT=<folder of the project> -P tests/tracer_core_size.cmake

cmake_minimum_required(VERSION 3.25)

function(check_size name most_lines)
  set(count 0)
  foreach(file IN LISTS ARGN)
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
    message(FATAL_ERROR "the ray tracer's ${name} has ${count} lines of code, ${most_lines} are allowed")
  endif()
  message("the ray tracer's ${name} has ${count} lines of code")
endfunction()

check_size(core 500 ray.hpp viewing.hpp viewing.cpp acne.hpp acne.cpp footprint.hpp footprint.cpp straight_light.hpp straight_light.cpp
           ray_tracer.hpp ray_tracer.cpp)
check_size(sampling 300 sampling.hpp sampling.cpp sample_rows.hpp render.hpp render.cpp progress.hpp)
