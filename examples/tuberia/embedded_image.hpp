#pragma once
// Pictures inside of a page, so that it is one file.

#include <string>

#include "image/image.hpp"

namespace tuberia::cli {

/// What src="" of an <img> takes in place of a file's name. The image must not be empty.
std::string data_url(const Image<Rgba8>& image);

}  // namespace tuberia::cli
