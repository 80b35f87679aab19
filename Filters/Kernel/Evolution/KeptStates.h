// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * As many states of an evolution as a memory limit lets keep, evenly spread.
 */

#ifndef EVOLVING_KEPT_STATES_H
#define EVOLVING_KEPT_STATES_H

#include "Evolution/FlowState.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace evolving
{

/// Bytes of the values that a state holds, without its origin.
std::size_t bytesOf(const FlowState& state);
std::size_t bytesOf(const SurfaceMesh& mesh);

/**
 * States come one after the other and are numbered from 0. When they exceed the limit, every
 * second one is dropped; the first and the last are kept whatever the limit is. What remeshing gave
 * to several states is held, and counted, once.
 */
class KeptStates
{
public:
  /**
   * @param limit bytes
   * @param costOfDropping bytes that are in memory, too, once a state has been dropped: what it is
   * computed from again
   */
  explicit KeptStates(std::size_t limit, std::size_t costOfDropping = 0);

  /// Takes constant time in the mean.
  void append(std::shared_ptr<const FlowState> state);
  /// There must be one.
  void replaceLast(std::shared_ptr<const FlowState> state);

  /// Of all states that were appended.
  std::size_t size() const { return this->Size; }
  bool areAll() const { return this->Stride == 1; }
  /// Null before the first.
  const std::shared_ptr<const FlowState>& last() const { return this->Last; }
  /// A state, if it is kept, or the nearest kept one before it. @param number below size()
  const std::shared_ptr<const FlowState>& upTo(std::size_t number) const;

  std::size_t bytes() const { return this->BytesOnStride + this->bytesOfLast(); }
  /// How many states all appends together looked at again: fewer than there were.
  std::size_t revisits() const { return this->Revisits; }

private:
  void thinOut();
  void halve();
  void pushOnStride(std::shared_ptr<const FlowState> state);
  void popFromStride();
  bool isLastOnStride() const;
  std::size_t bytesOfLast() const;
  std::size_t limit() const;

  std::size_t Limit;
  std::size_t CostOfDropping;
  std::size_t Stride = 1;
  std::size_t Size = 0;
  std::size_t BytesOnStride = 0;
  std::size_t Revisits = 0;
  std::vector<std::shared_ptr<const FlowState>> OnStride; ///< numbers 0, Stride, 2 Stride, ...
  std::shared_ptr<const FlowState> Last;
};

} // namespace evolving

#endif
