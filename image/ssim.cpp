#include "image/ssim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tuberia {
namespace {

constexpr int kWindowPixels = 11;
constexpr double kSigmaPixels = 1.5;
constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
constexpr double kC2 = (0.03 * 255) * (0.03 * 255);

/// What the formula needs of both lumas x and y: the windowed means of these five.
enum Moment { x, y, xx, yy, xy, kMomentCount };
using Row = std::vector<double>;
using MomentRows = std::array<Row, kMomentCount>;

/// The weights of a window along one axis; they sum to 1.
std::vector<double> gaussian(int length) {
  std::vector<double> weights(static_cast<std::size_t>(length));
  double sum = 0.0;
  for (int i = 0; i < length; ++i) {
    const double offset = i - 0.5 * (length - 1);
    sum += weights[i] = std::exp(-offset * offset / (2.0 * kSigmaPixels * kSigmaPixels));
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// The luma of Rec. 601, which the paper's program uses, in codes 0..255.
double luma(const Rgba8& pixel) { return 0.299 * pixel.r + 0.587 * pixel.g + 0.114 * pixel.b; }

MomentRows moments_of_row(std::span<const Rgba8> a, std::span<const Rgba8> b) {
  MomentRows moments;
  for (Row& row : moments) row.resize(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double luma_a = luma(a[i]), luma_b = luma(b[i]);
    moments[x][i] = luma_a;
    moments[y][i] = luma_b;
    moments[xx][i] = luma_a * luma_a;
    moments[yy][i] = luma_b * luma_b;
    moments[xy][i] = luma_a * luma_b;
  }
  return moments;
}

/// Every window's weighted mean along one row; shorter than the row by the window less one.
MomentRows filter_along(const MomentRows& rows, const std::vector<double>& weights) {
  MomentRows filtered;
  for (int moment = 0; moment < kMomentCount; ++moment) {
    Row& to = filtered[moment];
    to.assign(rows[moment].size() - weights.size() + 1, 0.0);
    for (std::size_t tap = 0; tap < weights.size(); ++tap) {
      const double* from = rows[moment].data() + tap;
      for (std::size_t i = 0; i < to.size(); ++i) to[i] += weights[tap] * from[i];
    }
  }
  return filtered;
}

/// Equation 13 of the paper, summed over one row of windows.
double sum_of_ssim(const MomentRows& means) {
  double sum = 0.0;
  for (std::size_t i = 0; i < means[x].size(); ++i) {
    const double mean_x = means[x][i], mean_y = means[y][i];
    const double variances = (means[xx][i] - mean_x * mean_x) + (means[yy][i] - mean_y * mean_y);
    const double covariance = means[xy][i] - mean_x * mean_y;
    sum += (2.0 * mean_x * mean_y + kC1) * (2.0 * covariance + kC2) /
           ((mean_x * mean_x + mean_y * mean_y + kC1) * (variances + kC2));
  }
  return sum;
}

}  // namespace

double mean_ssim(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  const std::vector<double> across = gaussian(std::min(kWindowPixels, a.width()));
  const std::vector<double> down = gaussian(std::min(kWindowPixels, a.height()));
  const int window_height = static_cast<int>(down.size());

  // The filter is separable: rows first, then down the last few filtered rows, kept in a ring.
  std::vector<MomentRows> ring(down.size());
  double sum = 0.0;
  for (int row = 0; row < a.height(); ++row) {
    ring[row % window_height] = filter_along(moments_of_row(a.row(row), b.row(row)), across);
    const int first = row - window_height + 1;
    if (first < 0) continue;
    MomentRows means;
    for (int moment = 0; moment < kMomentCount; ++moment) {
      means[moment].assign(ring[0][moment].size(), 0.0);
      for (int tap = 0; tap < window_height; ++tap) {
        const Row& from = ring[(first + tap) % window_height][moment];
        for (std::size_t i = 0; i < from.size(); ++i) means[moment][i] += down[tap] * from[i];
      }
    }
    sum += sum_of_ssim(means);
  }
  const double windows = static_cast<double>(a.width() - static_cast<int>(across.size()) + 1) *
                         (a.height() - window_height + 1);
  return sum / windows;
}

}  // namespace tuberia
