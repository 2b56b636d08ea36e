// Random factors that depend on nothing but a seed and what they are for: the same on any number of ranks, in any order.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace swellflow {

/// The mixing function of SplitMix64: Steele, Lea and Flood, OOPSLA (2014).
inline std::uint64_t mixed(std::uint64_t z)
{
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// What a number is for: two for different purposes have nothing to do with each other, whatever the seeds are.
enum class Purpose : std::uint64_t { swelling_rate, swelling_size, object_size, object_place };

/// Uniform in (0, 1); `draw` counts the numbers for one purpose.
inline double uniform_number(Purpose purpose, std::uint64_t seed, std::uint64_t object, std::uint64_t draw)
{
  const std::uint64_t bits = mixed(mixed(mixed(mixed(static_cast<std::uint64_t>(purpose)) ^ seed) ^ object) ^ draw);
  return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
}

/// Of mean 0 and standard deviation 1, from the uniform numbers 2 draw and 2 draw + 1: Box and Muller, Ann. Math. Stat. 29, 610 (1958).
inline double normal_number(Purpose purpose, std::uint64_t seed, std::uint64_t object, std::uint64_t draw)
{
  const double u = uniform_number(purpose, seed, object, 2 * draw), v = uniform_number(purpose, seed, object, 2 * draw + 1);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

/// Lognormal, of mean 1 and standard deviation `spread`.
inline double lognormal_factor(Purpose purpose, double spread, std::uint64_t seed, std::uint64_t object)
{
  const double variance = std::log1p(spread * spread);
  return std::exp(std::sqrt(variance) * normal_number(purpose, seed, object, 0) - 0.5 * variance);
}

}  // namespace swellflow
