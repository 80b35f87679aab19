// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A filter with parameters for one input, and the judge of its answers.
 */

#ifndef ROBUSTNESS_FILTER_CASE_H
#define ROBUSTNESS_FILTER_CASE_H

#include "Draws.h"
#include "Subject.h"
#include "Verdict.h"

#include <memory>
#include <vector>

class vtkAlgorithm;

namespace robustness
{

class FilterCase
{
public:
  FilterCase(const Subject& subject, Random& random)
    : Input(subject)
    , Parameters(random)
  {
  }
  virtual ~FilterCase() = default;

  virtual vtkAlgorithm* filter() = 0;
  virtual void update();
  /// One line: the parameters that are not defaults, and other inputs.
  virtual std::string describe();

  /// Why the answer must be an error; empty where a result is expected too.
  virtual std::string whyRefuse() const = 0;
  /// Must there be a result?
  virtual bool mustAccept() const = 0;
  /// May there be nothing in an output, without a word?
  virtual bool mayBeEmpty() const { return this->Input.model.points.empty(); }
  /// Are all numbers of all outputs finite? @throws WrongAnswer
  virtual void requireNumbers();
  /// The answer that is no error, with so many warnings. @throws WrongAnswer
  virtual void judge(std::size_t warnings) = 0;

protected:
  /// What is an error to every filter that takes surfaces; empty otherwise.
  std::string whySurfaceIsRefused() const;

  const Subject& Input;
  Draws Parameters;
};

struct FilterKind
{
  const char* name;
  int weight; ///< how often it is drawn
  std::unique_ptr<FilterCase> (*make)(const Subject& subject, Random& random);
};

const std::vector<FilterKind>& filterKinds();
/// @throws std::invalid_argument with the names there are
const FilterKind& filterKind(const std::string& name);
const FilterKind& drawFilter(std::uint64_t seed);

///@{
std::unique_ptr<FilterCase> makeMeshSDFCase(const Subject& subject, Random& random);
std::unique_ptr<FilterCase> makeEvolutionCase(const Subject& subject, Random& random);
std::unique_ptr<FilterCase> makeRedistributionCase(const Subject& subject, Random& random);
std::unique_ptr<FilterCase> makeWrapCase(const Subject& subject, Random& random);
std::unique_ptr<FilterCase> makeHierarchyCase(const Subject& subject, Random& random);
std::unique_ptr<FilterCase> makeLabelCase(const Subject& subject, Random& random);
std::unique_ptr<FilterCase> makeSourceCase(const Subject& subject, Random& random);
///@}

} // namespace robustness

#endif
