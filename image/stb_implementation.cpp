// The one place where stb's functions are compiled. Only the formats that our models and tests
// use: the decoders left out (GIF, PSD, PIC) have a history of reading out of bounds, and for .hdr
// and PNM we have our own, for the reasons that radiance.hpp and pnm.hpp give.

#include "image/stb_functions.hpp"

#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

// STBI_WRITE_NO_STDIO would take the encoder of .hdr away, the one into memory too.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
