// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Eight floats side by side, by the vector extensions of GCC and Clang. Included once for every
 * instruction set, inside a namespace of its own: no guard, no includes. All operations but
 * roughSum() round the same way on every processor, so all sets give the same bits.
 */

// The alignment is said again because without AVX the compiler takes 16.
using Lanes = float __attribute__((vector_size(32), aligned(32)));
using IntLanes = int __attribute__((vector_size(32), aligned(32)));

constexpr int LaneCount = 8;

inline Lanes all(float value)
{
  return Lanes{ value, value, value, value, value, value, value, value };
}

inline IntLanes all(int value)
{
  return IntLanes{ value, value, value, value, value, value, value, value };
}

inline Lanes load(const float* values)
{
  return Lanes{ values[0], values[1], values[2], values[3], values[4], values[5], values[6],
    values[7] };
}

inline Lanes smaller(Lanes a, Lanes b)
{
#if EVOLVING_LANES_HAVE_AVX
  return __builtin_ia32_minps256(a, b);
#else
  return a < b ? a : b;
#endif
}

inline Lanes larger(Lanes a, Lanes b)
{
#if EVOLVING_LANES_HAVE_AVX
  return __builtin_ia32_maxps256(a, b);
#else
  return a > b ? a : b;
#endif
}

inline Lanes magnitude(Lanes a)
{
  return (Lanes)((IntLanes)a & 0x7fffffff);
}

inline Lanes withSignOf(Lanes positive, Lanes sign)
{
  return (Lanes)((IntLanes)positive | ((IntLanes)sign & static_cast<int>(0x80000000U)));
}

/// Bit k is set where lane k of a comparison holds.
inline unsigned maskOf(IntLanes comparison)
{
#if EVOLVING_LANES_HAVE_AVX
  return static_cast<unsigned>(__builtin_ia32_movmskps256((Lanes)comparison));
#else
  unsigned mask = 0;
  for (int k = 0; k < LaneCount; ++k)
  {
    mask |= comparison[k] ? 1U << k : 0U;
  }
  return mask;
#endif
}

/// a * b + c, rounded once or twice: for bounds that have a margin, not for results.
inline Lanes roughSum(Lanes a, Lanes b, Lanes c)
{
#if EVOLVING_LANES_HAVE_AVX
  return __builtin_ia32_vfmaddps256(a, b, c);
#else
  return a * b + c;
#endif
}

inline Lanes squareRoot(Lanes a)
{
#if EVOLVING_LANES_HAVE_AVX
  return __builtin_ia32_sqrtps256(a);
#else
  Lanes root = a;
  for (int k = 0; k < LaneCount; ++k)
  {
    root[k] = std::sqrt(a[k]);
  }
  return root;
#endif
}
