// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The error of fast sweeping, as section 5.3 of the thesis studies it: the sum of
 * (d - d_exact)^2 / N over resolutions, and after each sweep.
 */

#include "Arguments.h"
#include "Models.h"
#include "Report.h"
#include "SampledDistance.h"
#include "Slope.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace benchmark;

namespace
{

/// Gives the exact distance at the samples of an image of the model.
using Exact = std::function<std::vector<float>(vtkImageData*)>;

Sampling sweeping(int size, int sweeps, int threads)
{
  return { size, vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::FLOOD_FILL, threads, sweeps };
}

/// The exponent between the last two entries, or nothing yet.
std::string lastOrder(const std::vector<double>& spacings, const std::vector<double>& errors)
{
  const std::size_t n = errors.size();
  return n < 2
    ? ""
    : fixed(
        exponentOf({ spacings.end() - 2, spacings.end() }, { errors.end() - 2, errors.end() }), 2);
}

void printResolutions(
  const Model& model, const std::string& reference, const Exact& exact, const Arguments& arguments)
{
  Table table("Error of FastSweeping over resolutions: " + model.name + ", exact: " + reference,
    { "grid", "h", "sum (d-d_exact)^2/N", "order", "mean error", "order", "mean, cells",
      "largest, cells" });
  std::vector<double> spacings;
  std::vector<double> squares;
  std::vector<double> means;
  for (const int size : arguments.sizes)
  {
    const auto image = sampleDistance(model.surface, sweeping(size, 8, arguments.threads));
    const double h = image->GetSpacing()[0];
    const Difference error = difference(values(image), exact(image), h);
    spacings.push_back(h);
    squares.push_back(error.meanSquare * h * h);
    means.push_back(error.mean * h);
    table.add({ cube(size), general(h), general(squares.back(), 4), lastOrder(spacings, squares),
      general(means.back(), 4), lastOrder(spacings, means), fixed(error.mean, 4),
      fixed(error.largest, 3) });
  }
  if (spacings.size() > 1)
  {
    table.note("slope of the mean error: " + fixed(exponentOf(spacings, means), 3) +
      " (wanted: at least 0.9); of the sum: " + fixed(exponentOf(spacings, squares), 3));
  }
  table.note("The thesis has no figures here but a rate: the sum falls by the ratio of the numbers"
             " of cells, order 3;");
  table.note("that is too good for a first-order scheme, whose order is 2.");
  table.print();
}

/// The error of the samples that some sweeps have reached.
struct SweptError
{
  double reached = 0.0; ///< as a fraction of all samples
  double spacing = 0.0;
  Difference error;
};

SweptError errorOf(vtkImageData* image, const std::vector<float>& expected)
{
  constexpr float Unreached = 1e20F; // sweeping starts above any distance
  const std::vector<float> all = values(image);
  std::vector<float> swept;
  std::vector<float> known;
  for (std::size_t s = 0; s < all.size(); ++s)
  {
    if (std::abs(all[s]) < Unreached)
    {
      swept.push_back(all[s]);
      known.push_back(expected[s]);
    }
  }
  const double h = image->GetSpacing()[0];
  return { static_cast<double>(swept.size()) / static_cast<double>(all.size()), h,
    difference(swept, known, h) };
}

void printSweeps(
  const Model& model, const std::string& reference, const Exact& exact, const Arguments& arguments)
{
  // The middle of the sizes: large enough for a far field, small enough to see the first sweeps.
  const int size = arguments.sizes[arguments.sizes.size() / 2];
  Table table(
    "Error after each sweep at " + cube(size) + ": " + model.name + ", exact: " + reference,
    { "sweeps", "reached", "sum (d-d_exact)^2/N", "mean, cells", "largest, cells" });
  const auto after = [&](int sweeps)
  { return sampleDistance(model.surface, sweeping(size, sweeps, arguments.threads)); };
  const std::vector<float> expected = exact(after(1)); // of the grid, whatever its values
  for (const int sweeps : { 1, 2, 3, 4, 5, 6, 7, 8, 16 })
  {
    const SweptError swept = errorOf(after(sweeps), expected);
    table.add({ std::to_string(sweeps), fixed(100.0 * swept.reached, 2) + " %",
      general(swept.error.meanSquare * swept.spacing * swept.spacing, 4),
      fixed(swept.error.mean, 4), fixed(swept.error.largest, 3) });
  }
  table.note("Sums are over the samples reached so far. The thesis (figure 5.6): the most"
             " significant changes occur up to sweep 4.");
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 32, 45, 64, 128, 256 };
  defaults.runs = 1;
  const Arguments arguments = readArguments(
    argc, argv, defaults, "The error of FastSweeping over resolutions and after each sweep.");
  printHeader("ErrorStudy", arguments);

  const Model sphere =
    unitSphere(*std::max_element(arguments.sizes.begin(), arguments.sizes.end()));
  printResolutions(sphere, "| |x| - 1 |", distanceToUnitSphere, arguments);
  printSweeps(sphere, "| |x| - 1 |", distanceToUnitSphere, arguments);
  for (const std::string& path : arguments.models)
  {
    const Model scan = readScan(path, arguments.subdivisions);
    const Exact bruteForce = [&](vtkImageData* image)
    {
      const Sampling sampling{ image->GetDimensions()[0], vtkMeshSDF::BRUTE_FORCE,
        vtkMeshSDF::UNSIGNED, arguments.threads };
      return values(sampleDistance(scan.surface, sampling));
    };
    printResolutions(scan, "BruteForce", bruteForce, arguments);
    printSweeps(scan, "BruteForce", bruteForce, arguments);
  }
  return 0;
}
