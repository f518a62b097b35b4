#pragma once
// To be included before stb's headers: their functions are those that this library compiled, and none of the
// same names that another shared library exports (Debian's libdraco does, which Assimp brings along). Otherwise
// the linker takes whichever it meets first, and with it decoders that we left out on purpose.

#define STBIDEF extern __attribute__((visibility("hidden")))
#define STBIWDEF extern "C" __attribute__((visibility("hidden")))
