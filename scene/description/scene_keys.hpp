#pragma once
// All keys of a scene file.

#include "scene/description/keys.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia::description {

void scene_keys(Keys&, SceneDescription&);

// Its parts.
void camera_keys(Keys&, Camera&);
void picture_keys(Keys&, Picture&);
void tracing_keys(Keys&, Tracing&);
void light_keys(Keys&, Light&);
void texture_keys(Keys&, Texture&);
void material_keys(Keys&, Material&);
void environment_keys(Keys&, Environment&);
void shape_keys(Keys&, Shape&);
void transform_keys(Keys&, Transform&);

}  // namespace tuberia::description
