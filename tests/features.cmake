# Lists the techniques of the course notes that have no test: each row of the table of features is the tag of
# at least one test case, such as [A09]. Fails when the list is not empty.
#   cmake -D ROOT=<folder of the project> -P tests/features.cmake

cmake_minimum_required(VERSION 3.25)

# rows(<letter> <first> <last>): "B 2 43" appends B02 to B43 to `rows`.
set(rows "")
macro(rows letter first last)
  foreach(number RANGE ${first} ${last})
    if(number LESS 10)
      set(number 0${number})
    endif()
    list(APPEND rows ${letter}${number})
  endforeach()
endmacro()

# A: realism in rasterization: textures, mipmaps, bump maps; shadows by depth map; environment maps.
rows(A 1 14)
rows(A 18 20)
rows(A 27 37)
# B: light, local reflection, shading, texture, roughness.
rows(B 2 43)
# A, B, C: ray tracing, its accelerators and its sampling.
rows(A 40 47)
rows(B 50 79)
rows(C 40 45)
# C: cameras; blending, buffers, rendering to textures.
rows(C 7 7)
rows(C 9 17)
rows(C 36 38)

file(GLOB_RECURSE files ${ROOT}/tests/*_test.cpp)
set(tags " ")
foreach(file IN LISTS files)
  file(STRINGS ${file} lines REGEX "\"[^\"]*\\[[ABC][0-9][0-9]\\]")
  foreach(line IN LISTS lines)
    # CMake's lists may not hold brackets: the tags become words.
    string(REGEX MATCHALL "\\[[ABC][0-9][0-9]\\]" found "${line}")
    string(REGEX REPLACE "[][;]" " " found "${found}")
    string(APPEND tags " ${found} ")
  endforeach()
endforeach()

set(missing "")
foreach(row IN LISTS rows)
  if(NOT tags MATCHES " ${row} ")
    list(APPEND missing ${row})
  endif()
endforeach()

list(LENGTH rows count)
if(missing)
  list(LENGTH missing left)
  list(JOIN missing " " missing)
  message(FATAL_ERROR "${left} of ${count} features have no test: ${missing}")
endif()
message("each of the ${count} features has a test")
