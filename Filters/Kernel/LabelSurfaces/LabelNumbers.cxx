// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelNumbers.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <unordered_map>

namespace evolving
{

namespace
{

/// How many of what was found a sentence names.
constexpr std::size_t MostNamed = 10;

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
  std::ostringstream message;
  (message << ... << parts);
  throw InputError(message.str());
}

template <class Labels>
std::string inWords(const Labels& labels)
{
  std::ostringstream words;
  std::size_t count = 0;
  for (const double label : labels)
  {
    if (count == MostNamed)
    {
      words << ", ...";
      break;
    }
    words << (count++ > 0 ? ", " : "") << label;
  }
  return count > 0 ? words.str() : "none";
}

void requireVolume(const std::array<Index, 3>& sizes)
{
  if (*std::min_element(sizes.begin(), sizes.end()) < 2)
  {
    refuse("The image has ", sizes[0], " x ", sizes[1], " x ", sizes[2],
      " voxels, expected at least two along every axis: a slice bounds no volume, give all slices "
      "as one image.");
  }
}

/// The number of each label as it is met; what has none gets one, or is background.
class Numbering
{
public:
  explicit Numbering(const LabelChoice& choice)
    : Choice(choice)
  {
    this->Known[choice.background] = Background;
    for (const double label : choice.labels)
    {
      this->number(label, true);
    }
  }

  Material of(double value)
  {
    if (value != this->LastValue)
    {
      this->LastNumber = this->number(value, this->Choice.labels.empty());
      this->LastValue = value;
    }
    return this->LastNumber;
  }

  const std::vector<double>& labels() const { return this->Labels; }
  /// Values that were met and have no label.
  const std::set<double>& others() const { return this->Others; }

private:
  Material number(double value, bool isWanted)
  {
    const auto known = this->Known.find(value);
    if (known != this->Known.end())
    {
      return known->second;
    }
    if (!std::isfinite(value) || value != std::floor(value))
    {
      refuse("The image has the value ", value,
        ", expected labels, which are whole numbers; take the image of labels, or make one of "
        "intensities by a threshold.");
    }
    if (isWanted && this->Labels.size() == MostLabels)
    {
      refuse(
        "The image has more than ", MostLabels, " labels, expected no more; choose some of them.");
    }
    if (isWanted)
    {
      this->Labels.push_back(value);
    }
    else if (this->Others.size() <= MostNamed)
    {
      this->Others.insert(value);
    }
    const auto number = static_cast<Material>(isWanted ? this->Labels.size() : Background);
    this->Known.emplace(value, number);
    return number;
  }

  const LabelChoice& Choice;
  std::unordered_map<double, Material> Known;
  std::vector<double> Labels;
  std::set<double> Others;
  double LastValue = std::nan("");
  Material LastNumber = Background;
};

/// From the order in which they were met to the ascending one.
void sortLabels(NumberedLabels& result)
{
  std::vector<double> sorted = result.labels;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Material> numbers(sorted.size() + 1, Background);
  for (std::size_t i = 0; i < result.labels.size(); ++i)
  {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), result.labels[i]);
    numbers[i + 1] = static_cast<Material>(place - sorted.begin() + 1);
  }
  for (Material& material : result.materials)
  {
    material = numbers[material];
  }
  result.labels = std::move(sorted);
}

void requireLabels(const std::array<Index, 3>& sizes, const NumberedLabels& result)
{
  GridIndex pairs = 0;
  GridIndex changes = 0;
  for (std::size_t i = 1; i < result.materials.size(); ++i)
  {
    const Material before = result.materials[i - 1];
    const Material here = result.materials[i];
    const bool isPair = i % at(sizes[0]) != 0 && (before != Background || here != Background);
    pairs += isPair ? 1 : 0;
    changes += isPair && before != here ? 1 : 0;
  }
  // Two labels may well be single voxels; an image that changes everywhere has many values.
  constexpr std::size_t FewLabels = 64;
  if (2 * changes > pairs && result.labels.size() > FewLabels)
  {
    refuse("The image has ", result.labels.size(), " values, and ", 100 * changes / pairs,
      " % of neighbouring voxels differ, expected labels, which neighbours share; take the image "
      "of "
      "labels, or choose labels to have surfaces of.");
  }
}

} // namespace

NumberedLabels numberLabels(const std::array<Index, 3>& sizes,
  const std::function<double(GridIndex)>& value, const LabelChoice& choice,
  const Execution& execution)
{
  requireVolume(sizes);
  if (!std::isfinite(choice.background) || choice.background != std::floor(choice.background))
  {
    refuse("BackgroundLabel is ", choice.background, ", expected a whole number; labels are.");
  }
  Numbering numbering(choice);
  NumberedLabels result;
  const GridIndex slice = static_cast<GridIndex>(sizes[0]) * sizes[1];
  result.materials.reserve(at(slice * sizes[2]));
  for (Index k = 0; k < sizes[2]; ++k)
  {
    execution.report(static_cast<double>(k) / sizes[2]);
    for (GridIndex i = slice * k; i < slice * (k + 1); ++i)
    {
      result.materials.push_back(numbering.of(value(i)));
    }
  }
  result.labels = numbering.labels();
  const bool isChosen = !choice.labels.empty();
  const bool hasAny = std::any_of(result.materials.begin(), result.materials.end(),
    [](Material material) { return material != Background; });
  if (isChosen && !hasAny)
  {
    refuse("The image has none of the chosen labels ", inWords(choice.labels),
      ", expected one at least; beside the background it has ", inWords(numbering.others()), ".");
  }
  if (!isChosen)
  {
    requireLabels(sizes, result);
  }
  sortLabels(result);
  return result;
}

} // namespace evolving
