#pragma once
// A scene that says everything that a scene file can say.

namespace tuberia {

inline constexpr const char* kEveryKey = R"({
  "title": "All keys", "caption": "Nothing to see", "source": "none",
  "image": {"width": 64, "height": 48, "supersampling": 2, "background": [0.1, 0.2, 0.3], "exposure_stops": 0.5, "overflow": "global-scale"},
  "trace": {"depth": 7, "least_weight": 0.01, "samples": 16, "pattern": "jittered", "seed": 4, "adaptive": true, "contrast": [0.3, 0.2, 0.5], "filter": "gaussian", "filter_radius": 1.5},
  "camera": {"type": "perspective", "eye": [0, 1, 6], "look_at": [0, 0.5, 0], "up": [0, 1, 0.1], "fovy_degrees": 35, "near": 0.2, "far": 50,
    "motions": [{"type": "pan", "right": 1, "up": 0.5}, {"type": "dolly", "distance": 1}, {"type": "zoom", "factor": 1.5},
                {"type": "orbit", "right_degrees": 90, "up_degrees": 10, "inspection": true},
                {"type": "turn", "pitch_degrees": 1, "yaw_degrees": 2, "roll_degrees": 3}]},
  "ambient": 0.3,
  "lights": [
    {"type": "directional", "name": "sun", "towards": [1, 2, 3], "intensity": [1, 0.9, 0.8], "look_at": [0, 0, 1], "projection": {"texture": "slide", "up": [0, 0, 1], "fovy_degrees": 30, "height": 2},
     "shadow": {"resolution": 512, "constant_bias": 0.001, "slope_bias": 1.5, "normal_offset": 0.01, "taps": 3}},
    {"type": "point", "position": [1, 4, 1], "falloff": "inverse-square"},
    {"type": "spot", "position": [-1, 4, 1], "look_at": [0, 0, 0.5], "cone_degrees": 40, "full_cone_degrees": 20, "falloff": "linear", "falloff_distance": 2},
    {"type": "area", "position": [0, 5, 0], "edge_u": [1, 0, 1], "edge_v": [-1, 0, 1], "samples": 3}],
  "textures": {
    "slide": {"source": "checker", "size": 64, "squares": 4, "first": [1, 0, 0], "second": [0, 0, 1], "filter": "bilinear", "wrap": "clamp"},
    "wall": {"source": "file", "file": "wall.png", "encoding": "linear", "filter": "mipmap-nearest", "anisotropy": 4, "wrap": "mirror", "level_rule": "distance", "texel_distance": 3},
    "levels": {"source": "gradient", "level_colours": true, "filter": "nearest"},
    "earth": {"source": "planet", "seed": 2}, "wall of bricks": {"source": "bricks", "squares": 6}, "studs": {"source": "stud-heights"},
    "squares": {"source": "random-squares", "seed": 7, "filter": "trilinear", "wrap": "repeat"}},
  "materials": {
    "mat": {"model": "lambert", "ambient": 0.1, "diffuse": 0.5, "two_sided": true, "alpha": 0.5, "texture": "wall", "mapping": {"type": "surface", "repeat": [2, 3]}},
    "plastic": {"model": "phong", "specular": 0.4, "exponent": 10, "pattern": {"type": "checker", "first": 0.9, "second": 0.1, "scale": 4},
                "bump": {"type": "waves", "gain": 0.02, "scale": 6}},
    "lacquer": {"model": "blinn-phong", "pattern": {"type": "wood", "seed": 3, "turbulence": 0.2, "placement": [{"translate": [0, 1, 0]}]},
                "bump": {"type": "orange", "seed": 5}, "mirror": 0.2},
    "glazed": {"model": "weighted-phong", "refractive_index": 1.3, "pattern": {"type": "marble"}, "bump": {"type": "normal-map", "texture": "squares"}},
    "gold": {"model": "cook-torrance", "specular": 1, "roughness": 0.2, "facets": "gaussian", "refractive_index": [0.5, 0.6, 1.2], "divided_by_pi": false,
             "texture": "squares", "mapping": {"type": "sphere", "pole": [0, 0, 1], "equator": [0, 1, 0], "of_positions": true}, "bump": {"type": "height-texture", "texture": "levels"}},
    "glass": {"model": "phong", "transmission": [0.8, 0.9, 0.85], "refractive_index": 1.4, "shadow_density": 0.3},
    "rough": {"pattern": {"type": "random-squares"}, "bump": {"type": "rough"}}},
  "environment": {"source": "sky", "resolution": 64, "look_up": "panorama", "rotation_degrees": 30, "shown": false,
    "sky": {"zenith": [0, 0, 1], "horizon": 0.8, "ground": 0.1, "sun_towards": [0, 1, 1], "sun_degrees": 3, "sun": 10, "glow": 1, "cloudiness": 0, "seed": 2}},
  "objects": [
    {"name": "floor", "shape": {"type": "plane", "width": 10, "depth": 8, "segments": [2, 3]}, "material": "mat", "casts_shadow": false, "seen_in_environment": false},
    {"shape": {"type": "cube", "size": [1, 2, 3], "segments": 2}, "material": "plastic", "normals": "facet", "shading": "flat"},
    {"shape": {"type": "sphere", "radius": 0.5, "segments": [20, 10]}, "material": "lacquer", "normals": "averaged", "crease_degrees": 40, "shading": "gouraud"},
    {"shape": {"type": "cylinder", "radius": 0.5, "height": 1, "capped": false}, "material": "glazed", "shading": "dot-product"},
    {"shape": {"type": "cone", "radius": 0.5, "height": 1, "capped": false}, "material": "gold", "shading": "phong"},
    {"shape": {"type": "torus", "ring_radius": 1, "tube_radius": 0.3}, "material": "rough", "normals": "exact"},
    {"shape": {"type": "disc", "radius": 0.5}, "transforms": [{"translate": [1, 2, 3]}, {"rotate": 30, "about": [0, 1, 0]}, {"scale": [1, 2, 1]},
      {"matrix": [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]}]},
    {"shape": {"type": "teapot", "size": 0.5}},
    {"shape": {"type": "bezier-patches", "patches": [{"points": [[0,0,0],[1,0,0],[2,0,0],[3,0,0],[0,1,1],[1,1,1],[2,1,1],[3,1,1],
      [0,2,1],[1,2,1],[2,2,1],[3,2,1],[0,3,0],[1,3,0],[2,3,0],[3,3,0]]}]}},
    {"shape": {"type": "height-field", "width": 3, "depth": 2, "height": 0.5, "heights": [[0, 1, 0], [1, 0, 1]]}},
    {"shape": {"type": "height-field", "texture": "levels"}},
    {"shape": {"type": "mesh", "positions": [[0,0,0],[1,0,0],[0,1,0]], "normals": [[0,0,1],[0,0,1],[0,0,1]], "texcoords": [[0,1],[1,1],[0,0]],
      "colours": [[1,0,0],[0,1,0],[0,0,1]], "triangles": [[0, 1, 2]]}},
    {"shape": {"type": "model", "file": "duck.obj", "own_materials": false, "unit_size": true}},
    {"shape": {"type": "infinite-plane"}},
    {"shape": {"type": "polygon", "outline": [[0,0,0],[3,0,0],[3,3,0],[0,3,0]], "holes": [{"points": [[1,1,0],[2,1,0],[1,2,0]]}]}},
    {"shape": {"type": "polyhedron", "planes": [[1,0,0,-1],[-1,0,0,-1],[0,1,0,-1],[0,-1,0,-1],[0,0,1,-1],[0,0,-1,-1]]}},
    {"shape": {"type": "quadric", "q": [[1,0,0,0.5],[0,-1,0,0],[0,0,1,0],[0.5,0,0,-1]], "lower": [-2,-1,-2], "upper": [2,1,2]}}
  ]
})";

/// What only other scenes can say.
inline constexpr const char* kOtherKeys = R"({
  "camera": {"type": "orthographic", "height": 3},
  "environment": {"source": "faces", "look_up": "sphere", "faces": {"+x": "a.png", "-x": "b.png", "+y": "c.png", "-y": "d.png", "+z": "e.png", "-z": "f.png"}}
})";
inline constexpr const char* kPanorama = R"({"environment": {"source": "panorama", "look_up": "cube", "file": "hall.hdr"}, "image": {"overflow": "clamp"}})";
inline constexpr const char* kRendered = R"({"environment": {"source": "rendered", "from": [0, 1, 0]}, "image": {"overflow": "hue-preserving"}})";

}  // namespace tuberia
