// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Sums and products of doubles without rounding.
 *
 * Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
 * Discrete & Computational Geometry 18, 1997. Needs rounding to nearest, and no overflow or
 * underflow of the products.
 */

#ifndef EVOLVING_EXPANSION_H
#define EVOLVING_EXPANSION_H

#include <array>
#include <cmath>
#include <cstddef>

namespace evolving
{

/// A number as an unevaluated sum of doubles, from the smallest term to the largest.
template <std::size_t Capacity>
class Expansion
{
public:
  std::size_t size() const { return this->Count; }
  double operator[](std::size_t i) const { return this->Terms[i]; }
  /// Appends a term that is larger than all others and does not overlap them; zero is left out.
  void append(double term)
  {
    this->Terms[this->Count] = term;
    this->Count += term != 0.0 ? 1 : 0;
  }
  /// The sign of the largest term is the sign of the sum.
  int sign() const
  {
    const double largest = this->Count > 0 ? this->Terms[this->Count - 1] : 0.0;
    return largest > 0.0 ? 1 : (largest < 0.0 ? -1 : 0);
  }

private:
  std::array<double, Capacity + 1> Terms; // one more, so that append() may write before it counts
  std::size_t Count = 0;
};

/// A rounded result and what rounding took from it.
struct RoundedValue
{
  double value;
  double error;
};

inline RoundedValue twoSum(double a, double b)
{
  const double sum = a + b;
  const double bPart = sum - a;
  const double aPart = sum - bPart;
  return { sum, (a - aPart) + (b - bPart) };
}

inline RoundedValue twoProduct(double a, double b)
{
  const double product = a * b;
  return { product, std::fma(a, b, -product) };
}

inline Expansion<2> exactProduct(double a, double b)
{
  const RoundedValue product = twoProduct(a, b);
  Expansion<2> result;
  result.append(product.error);
  result.append(product.value);
  return result;
}

/// Shewchuk's fast expansion sum: merges the terms by magnitude and adds them up.
template <std::size_t A, std::size_t B>
Expansion<A + B> operator+(const Expansion<A>& a, const Expansion<B>& b)
{
  Expansion<A + B> result;
  double carry = 0.0;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size())
  {
    const bool fromA = j == b.size() || (i < a.size() && std::abs(a[i]) < std::abs(b[j]));
    const RoundedValue sum = twoSum(carry, fromA ? a[i++] : b[j++]);
    result.append(sum.error);
    carry = sum.value;
  }
  result.append(carry);
  return result;
}

/// Shewchuk's scale expansion.
template <std::size_t A>
Expansion<2 * A> operator*(const Expansion<A>& a, double factor)
{
  Expansion<2 * A> result;
  double carry = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const RoundedValue product = twoProduct(a[i], factor);
    const RoundedValue low = twoSum(carry, product.error);
    const RoundedValue high = twoSum(product.value, low.value);
    result.append(low.error);
    result.append(high.error);
    carry = high.value;
  }
  result.append(carry);
  return result;
}

} // namespace evolving

#endif
