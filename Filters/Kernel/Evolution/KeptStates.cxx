// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/KeptStates.h"

#include <utility>

namespace evolving
{

namespace
{

/// What a state needs more when those before it are there. States that share an origin follow
/// each other.
std::size_t bytesAfter(
  const std::vector<std::shared_ptr<const FlowState>>& before, const FlowState& state)
{
  const bool isOriginNew = before.empty() || before.back()->origin != state.origin;
  const std::size_t traced = state.startPoints ? state.startPoints->size() * sizeof(Vec3) : 0;
  return bytesOf(state) + (isOriginNew ? bytesOf(*state.origin) + traced : 0);
}

} // namespace

std::size_t bytesOf(const FlowState& state)
{
  const StateArrays& arrays = state.arrays;
  const std::size_t vectors = state.points.size() + arrays.distanceGradient.size() +
    arrays.normal.size() + arrays.tangentialVelocity.size();
  const std::size_t scalars = state.curvePositions.size() + arrays.distance.size() +
    arrays.meanCurvature.size() + arrays.coVolume.size() + arrays.normalVelocity.size() +
    arrays.redistributionPotential.size();
  return vectors * sizeof(Vec3) + scalars * sizeof(double);
}

std::size_t bytesOf(const SurfaceMesh& mesh)
{
  return mesh.points.size() * sizeof(Vec3) +
    (mesh.faceOffsets.size() + mesh.cornerVertices.size()) * sizeof(Index);
}

KeptStates::KeptStates(std::size_t limit, std::size_t costOfDropping)
  : Limit(limit)
  , CostOfDropping(costOfDropping)
{
}

void KeptStates::append(std::shared_ptr<const FlowState> state)
{
  // What was the last state is one among others now: between strides it goes.
  this->Last = state;
  ++this->Size;
  if (this->isLastOnStride())
  {
    this->pushOnStride(std::move(state));
  }
  this->thinOut();
}

void KeptStates::replaceLast(std::shared_ptr<const FlowState> state)
{
  this->Last = state;
  if (this->isLastOnStride())
  {
    this->popFromStride();
    this->pushOnStride(std::move(state));
  }
  this->thinOut();
}

const std::shared_ptr<const FlowState>& KeptStates::upTo(std::size_t number) const
{
  return number + 1 == this->Size ? this->Last : this->OnStride[number / this->Stride];
}

void KeptStates::thinOut()
{
  while (this->bytes() > this->limit() && this->Stride < this->Size)
  {
    this->halve();
  }
}

void KeptStates::halve()
{
  this->Stride *= 2;
  this->Revisits += this->OnStride.size();
  this->BytesOnStride = 0;
  std::vector<std::shared_ptr<const FlowState>> all;
  all.swap(this->OnStride);
  for (std::size_t k = 0; k < all.size(); k += 2)
  {
    this->pushOnStride(std::move(all[k]));
  }
}

void KeptStates::pushOnStride(std::shared_ptr<const FlowState> state)
{
  this->BytesOnStride += bytesAfter(this->OnStride, *state);
  this->OnStride.push_back(std::move(state));
}

void KeptStates::popFromStride()
{
  const std::shared_ptr<const FlowState> state = std::move(this->OnStride.back());
  this->OnStride.pop_back();
  this->BytesOnStride -= bytesAfter(this->OnStride, *state);
}

bool KeptStates::isLastOnStride() const
{
  return (this->Size - 1) % this->Stride == 0;
}

std::size_t KeptStates::bytesOfLast() const
{
  return this->Size == 0 || this->isLastOnStride() ? 0 : bytesAfter(this->OnStride, *this->Last);
}

std::size_t KeptStates::limit() const
{
  const bool isRoom = this->Limit > this->CostOfDropping;
  return this->areAll() ? this->Limit : isRoom ? this->Limit - this->CostOfDropping : 0;
}

} // namespace evolving
