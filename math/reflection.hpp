#pragma once
// How surfaces reflect the light of a source: the local models, in double, one light at a time. This is
// their definition, which the fragment programs are compared with.                  [B 2, 4.2.2]

#include <cstdint>
#include <glm/vec3.hpp>

namespace tuberia {

enum class Reflection : std::uint8_t { lambert, phong, blinn_phong, weighted_phong, cook_torrance };

/// How many facets of a rough surface are tilted by the angle a, without 1/pi. beckmann:
/// exp(-(tan a / m)^2) / (m^2 cos^4 a); gaussian: exp(-(a / m)^2) / m^2, which for small m is the same.
enum class FacetDistribution : std::uint8_t { beckmann, gaussian };

/// The constants of a reflection model, linear RGB.
struct ReflectionConstants {
  Reflection model = Reflection::phong;
  glm::vec3 ambient{0.8f};           // ka, times the scene's ambient light; notes: often equal to kd
  glm::vec3 diffuse{0.8f};           // kd, times the surface's pattern or texture
  glm::vec3 specular{0};             // ks
  float exponent = 32;               // n of phong, blinn_phong and weighted_phong, >= 0
  float roughness = 0.3f;            // m of cook_torrance: root mean square slope of the facets, 1e-3 to 1e3
  glm::vec3 refractive_index{1.5f};  // of cook_torrance and of weighted_phong's W(theta), > 0, for each channel
  FacetDistribution facets = FacetDistribution::beckmann;  // of cook_torrance
  bool divided_by_pi = true;         // cook_torrance as the notes print it; false: as it was derived later [FIX 12]
  bool operator==(const ReflectionConstants&) const = default;
};

/// A lit point: normal, direction to the light and to the eye, all unit and away from the surface
/// (asserted in debug builds, [B 2.3]).
struct LitPoint {
  glm::dvec3 normal, to_light, to_eye;
};

// Shares of a light's intensity Ip that are sent to the eye, for one channel; 0 where the light is not
// above the surface.

/// max(N.L, 0): times kd, Lambert's law.                                               [B 2-3]
double diffuse_share(const LitPoint& at) noexcept;
/// max(R.V, 0)^n with R = 2 (N.L) N - L.                                               [B 2-7]
double phong_share(const LitPoint& at, double exponent) noexcept;
/// max(N.H, 0)^n with H halfway between L and V.                                       [C]
double blinn_phong_share(const LitPoint& at, double exponent) noexcept;
/// W(theta) max(R.V, 0)^n: W is what the surface of a clear material reflects of light that arrives at
/// the angle theta to the normal.                                                       [B 2-6]
double weighted_phong_share(const LitPoint& at, double exponent, double refractive_index) noexcept;
/// ks (N.L) with ks = D G F / (pi (N.V) (N.L)) as the notes print it, D without 1/pi. Not divided_by_pi:
/// pi ks (N.L) with ks = (D/pi) G F / (4 (N.V) (N.L)), the pi because Lambert's kd stands for kd/pi: all in
/// all 4 stands in pi's place.  0 where the eye is not above the surface.             [B 4.2.2] [FIX 12]
double cook_torrance_share(const LitPoint& at, const ReflectionConstants& constants, double refractive_index) noexcept;

/// What of one light arrives: kd times the first and ks times the model's own share, RGB, before it is
/// multiplied with the light's intensity.
glm::dvec3 reflected_share(const ReflectionConstants& constants, const LitPoint& at) noexcept;

/// The share of facets that are neither shadowed nor masked, in [0, 1], without the factor 1/(N.V):
/// min(1, 2 (N.H)(N.V) / (V.H), 2 (N.H)(N.L) / (V.H)).                                 [B 4.2.2]
double shadowing_and_masking(const LitPoint& at) noexcept;

/// D for the cosine of a, without 1/pi; 0 where it is not above 0. roughness: m, > 0.
double facet_density(FacetDistribution distribution, double cos_angle, double roughness) noexcept;

/// The share of unpolarized light that a clear material's surface reflects, from its refractive index
/// alone, n > 0, and the cosine c of the angle to the normal, in [0, 1]; with g^2 = n^2 + c^2 - 1
/// F = ((g - c) / (g + c))^2 (1 + ((c (g + c) - 1) / (c (g - c) + 1))^2) / 2: nothing is 0/0 in it. [FIX 11]
double fresnel_share(double cos_incidence, double refractive_index) noexcept;

/// What a light's intensity is multiplied with at the distance d, >= 0: linear 1/(d + d0), or inverse
/// square 1/(4 pi d^2).                                                                 [B 2-5]
double linear_falloff(double distance, double d0) noexcept;
double inverse_square_falloff(double distance) noexcept;

}  // namespace tuberia
