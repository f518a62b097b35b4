# Shows that architecture.cmake refuses each kind of bad include, and only those.
#   cmake -D SCRATCH=<folder to write into> -P tests/architecture_can_fail.cmake

cmake_minimum_required(VERSION 3.25)

# Judges a project that consists of one file with one include.
function(expect verdict file include)
  file(REMOVE_RECURSE ${SCRATCH})
  # Beside it the witnesses include a file that includes nothing yet.
  file(WRITE ${SCRATCH}/reference/witness.cpp "#include \"scene/between.hpp\"\n")
  file(WRITE ${SCRATCH}/${file} "#pragma once\n  # include ${include}  // why not\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} -P ${CMAKE_CURRENT_LIST_DIR}/architecture.cmake
                  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE output)
  if(verdict STREQUAL "refused" AND (status EQUAL 0 OR NOT output MATCHES "^${file}: "))
    message(SEND_ERROR "${file} with ${include} was not refused by name:\n${output}")
  elseif(verdict STREQUAL "allowed" AND NOT status EQUAL 0)
    message(SEND_ERROR "${file} with ${include} was refused:\n${output}")
  endif()
endfunction()

expect(refused raster/tile.hpp "<hwy/highway.h>")
expect(refused pipeline/clipping.cpp "\"hwy/highway.h\"")
expect(refused scene/kernel-inl.hpp "<hwy/highway.h>")
expect(refused reference/ray_tracer/geometry.cpp "<hwy/highway.h>")
expect(refused reference/ray_tracer/fast/fast_triangles.hpp "<hwy/highway.h>")
expect(allowed reference/ray_tracer/fast/bundle-inl.hpp "<hwy/highway.h>")
expect(allowed raster/simd/wide.hpp "<hwy/highway.h>")
expect(allowed pipeline/programs/phong.cpp "<hwy/foreach_target.h>")
expect(allowed pipeline/clipping-inl.hpp "<hwy/highway.h>")
expect(refused raster/tile.cpp "<tbb/parallel_for.h>")
expect(refused base/parallel_for.hpp "<oneapi/tbb.h>")
expect(allowed base/parallel_for.cpp "<tbb/parallel_for.h>")
expect(refused scene/load.cpp "<stb_image.h>")
expect(refused bench/peers/main.cpp "\"stb/stb_image_write.h\"")
expect(allowed image/read.cpp "<stb/stb_image.h>")
expect(refused reference/oracle/clipping.cpp "<gmpxx.h>")
expect(allowed reference/rational/number.hpp "<gmpxx.h>")

expect(refused base/result.hpp "\"math/spaces.hpp\"")
expect(refused image/image.hpp "\"math/colour.hpp\"")
expect(refused raster/setup.cpp "\"pipeline/state.hpp\"")
expect(refused reference/oracle.cpp "\"raster/coverage.hpp\"")
expect(refused reference/oracle.cpp "\"pipeline/state.hpp\"")
expect(refused scene/mesh.hpp "\"reference/oracle.hpp\"")
expect(refused scene/between.hpp "\"pipeline/state.hpp\"")
expect(allowed scene/beside.hpp "\"pipeline/state.hpp\"")
expect(refused examples/gallery.cpp "\"tests/helpers.hpp\"")
expect(allowed reference/oracle.cpp "\"scene/mesh.hpp\"")
expect(allowed tests/golden/teapot_test.cpp "\"reference/oracle.hpp\"")
expect(allowed raster/setup.cpp "<vector>")

expect(refused math/camera.cpp "\"camera.hpp\"")
expect(refused math/camera.cpp "\"../base/result.hpp\"")
