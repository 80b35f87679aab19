// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Options are equal only when all of their members are: those that membersOf() lists.
 */

#ifndef EVOLVING_CHANGED_MEMBERS_H
#define EVOLVING_CHANGED_MEMBERS_H

#include "Redistribution/RedistributionOptions.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace evolving
{

template <typename Value>
void change(Value& value)
{
  if constexpr (std::is_same_v<Value, bool>)
  {
    value = !value;
  }
  else
  {
    value = static_cast<Value>(static_cast<int>(value) + 1);
  }
}

inline void change(std::array<int, 3>& values)
{
  ++values[2];
}

inline void change(RedistributionOptions& options)
{
  ++options.length;
}

/// Options with that member of theirs changed, by its number.
template <std::size_t Member, typename Options>
Options withChanged(Options options)
{
  const auto& member = std::get<Member>(membersOf(options));
  change(const_cast<std::decay_t<decltype(member)>&>(member)); // of options, which are not const
  return options;
}

template <typename Options, std::size_t... Members>
void expectEachCounts(const Options& options, std::index_sequence<Members...>)
{
  const std::array<bool, sizeof...(Members)> isEqual = { (
    withChanged<Members>(options) == options)... };
  for (std::size_t i = 0; i < isEqual.size(); ++i)
  {
    EXPECT_FALSE(isEqual[i]) << "member " << i;
  }
}

template <typename Options>
void expectEveryMemberCounts(const Options& options)
{
  EXPECT_TRUE(options == options);
  using Members = decltype(membersOf(options));
  expectEachCounts(options, std::make_index_sequence<std::tuple_size_v<Members>>());
}

} // namespace evolving

#endif
