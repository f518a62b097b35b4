#pragma once
// All shapes. Each mesh has positions, unit normals, tangents dP/du and bitangents dP/dv of the ideal surface,
// and texture coordinates that show an image upright and unmirrored from outside; triangles are
// counter-clockwise from there. Closed shapes have equal positions to the last bit wherever parts of them meet.

#include "scene/shapes/bezier_patches.hpp"
#include "scene/shapes/flat_shapes.hpp"
#include "scene/shapes/height_field.hpp"
#include "scene/shapes/round_shapes.hpp"
#include "scene/shapes/teapot.hpp"
#include "scene/shapes/zigzag.hpp"
