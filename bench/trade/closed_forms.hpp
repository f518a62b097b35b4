#pragma once
// What theory says of the errors that the trade measures: by formulas, or by sums over all cases, from nothing of
// the machine. The figures that it is held against are those of [rules 4].

#include <glm/vec2.hpp>
#include <span>

namespace tuberia::bench::trade {

/// Wrong pixels per 1000 px of edge when vertices are rounded to 2^-bits pixel: a thousand times the mean distance
/// between an edge and its rounded self, over all directions and along all of the edge.
double wrong_pixels_by_rounding(int bits);

/// Perspective-correct coordinate, 0..1, at the share t of the way on the screen from w = 1 to w = w_right.
double perspective_coordinate(double t, double w_right) noexcept;

/// Largest error, in texels, of 256 texels over 256 pixels from w = 1 to w_right, when only every `step`-th pixel is
/// divided and the coordinate is linear between them. 256: affine mapping. phase: where in its pixel a step begins, 0
/// for the left edge, 0.5 for the centre; then the last step ends half a pixel beyond the texture.
double texel_error_by_steps(double w_right, int step, double phase = 0);

/// No error of the above can be larger: step^2 / 8 times the largest second derivative.
double texel_error_bound(double w_right, int step);

/// Which codes depths become.
enum class DepthCoding { unorm16, unorm24, float32, float32_reversed };

/// Share of pairs, 0..1, of distances spread evenly over the logarithm of 0.1..10000, one farther by a relative gap,
/// whose codes are equal or in the wrong order.
double misordered_pairs(DepthCoding coding, double relative_gap);

/// Root mean square, over all pixels that a straight edge crosses, of the share of samples on its side less the area
/// there. Directions: all, or those within `lean` radians of an axis. samples: pixels from the centre, -0.5..0.5.
double coverage_rms(std::span<const glm::dvec2> samples, double lean);

/// What Gouraud shading leaves of a highlight of 1 in the middle between normals that lean by an angle.
double gouraud_highlight(double lean_degrees, double shininess) noexcept;

/// Length of the mean of two unit normals at an angle: as it is, and after one step 1.5 - 0.5 n.n of renormalization.
double mean_normal_length(double between_degrees) noexcept;
double length_after_one_step(double between_degrees) noexcept;

/// Largest error of Schlick's t / (n - n t + t) in place of t^n, and of his Fresnel term in place of the exact one of
/// unpolarized light that enters glass of this index.
double schlick_power_error(double exponent);
double schlick_fresnel_error(double index);

/// Largest relative error of 1 / sqrt by its bits' halving (0x5f3759df), after so many Newton steps.
double fast_inverse_root_error(int newton_steps);

/// What is left of white under black layers of alpha 1/255, as a code of 255, when each is rounded to unorm8; and
/// exactly.
int white_under_layers_in_codes(int layers);
double white_under_layers(int layers) noexcept;

/// How many sRGB codes stay different when they are stored as linear 8-bit codes; and by how many codes at most a
/// power of 1/2.2 misses the sRGB encoding.
int srgb_codes_kept_by_linear_codes();
int codes_missed_by_plain_gamma();

/// Level of detail of a pixel's footprint, texels per pixel along x and y: by the longer of both over as many samples
/// as the shorter one asks for, or by the true ellipse's axes; at most so many samples.      [case 38]
double axis_level_of_detail(glm::dvec2 dx, glm::dvec2 dy, double most_samples) noexcept;
double ellipse_level_of_detail(glm::dvec2 dx, glm::dvec2 dy, double most_samples) noexcept;

}  // namespace tuberia::bench::trade
