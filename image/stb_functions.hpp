#pragma once
// To be included before stb's headers: their functions are those that this library compiled, and none of the
// same names that another shared library exports (Debian's libdraco does, which Assimp brings along). Otherwise
// the linker takes whichever it meets first, and with it decoders that we left out on purpose. Hidden alone is not
// enough: a linker that has met the other's name does not look for ours in an archive, and then may not use the other's.

#define STBIDEF extern __attribute__((visibility("hidden")))
#define STBIWDEF extern "C" __attribute__((visibility("hidden")))

// Those that we call, by names that nobody else has.
#define stbi_failure_reason tuberia_stbi_failure_reason
#define stbi_image_free tuberia_stbi_image_free
#define stbi_info_from_callbacks tuberia_stbi_info_from_callbacks
#define stbi_load_from_callbacks tuberia_stbi_load_from_callbacks
#define stbi_write_bmp_to_func tuberia_stbi_write_bmp_to_func
#define stbi_write_hdr_to_func tuberia_stbi_write_hdr_to_func
#define stbi_write_jpg_to_func tuberia_stbi_write_jpg_to_func
#define stbi_write_png_to_func tuberia_stbi_write_png_to_func
#define stbi_write_tga_to_func tuberia_stbi_write_tga_to_func
