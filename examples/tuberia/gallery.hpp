#pragma once
// The pictures of the gallery, and the page that shows them.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "examples/tuberia/render_model.hpp"

namespace tuberia::cli {

/// One picture: which model, how, and what to see in it.
struct GalleryEntry {
  std::string name;          // of the picture's file
  std::string model;         // path
  std::string package;       // the Debian package that it comes from
  std::string caption;
  Shading shading = Shading::automatic;
  double azimuth_degrees = 30, elevation_degrees = 15, zoom = 1;
  std::string up_axis = "y";
};

std::vector<GalleryEntry> gallery_entries();

/// A picture that was made, as the page shows it.
struct GalleryPicture {
  std::string file, title, caption, performance;
};

/// The contact sheet, one self-contained page beside its pictures.
std::string gallery_page(const std::vector<GalleryPicture>& pictures, const std::string& machine);

}  // namespace tuberia::cli
