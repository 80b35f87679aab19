// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterCase.h"
#include "LabelModel.h"
#include "OutputChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkLabelSurfaces.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace robustness
{

namespace
{

/// Of the voxels of a label, relative: what is promised, and what is not said in a warning.
constexpr double VolumeError = 0.01;
/// In voxels: of points 0.85, and of middles of edges between them a little more.
constexpr double MostDistance = 0.95;

/// vtkLabelSurfaces takes images, which it draws itself: the model is not used.
class LabelCase : public FilterCase
{
public:
  LabelCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
    , Labels(drawLabels(random, this->Parameters.isOdd()))
  {
    const bool isDefault = random.chance(0.6);
    this->Filter->SetSmoothingLength(
      this->Parameters.number("SmoothingLength", isDefault ? 2.0 : random.real(0.0, 6.0)));
    this->Filter->SetBackgroundLabel(this->Parameters.number("BackgroundLabel", 0.0));
    if (random.chance(0.2))
    {
      this->Filter->AddLabel(random.integer(1, 3));
    }
    this->Filter->SetInputDataObject(this->Labels.image);
  }

  vtkAlgorithm* filter() override { return this->Filter; }
  std::string describe() override { return FilterCase::describe() + ", of " + this->Labels.story; }

  std::string whyRefuse() const override
  {
    int sizes[3];
    this->Labels.image->GetDimensions(sizes);
    return *std::min_element(sizes, sizes + 3) < 2      ? "the image is a slice"
      : this->Labels.hasNaN || this->Labels.hasFraction ? "a value is no whole number"
      : this->Parameters.isNaN("SmoothingLength") || !this->isBackgroundWhole()
      ? "SmoothingLength is NaN or BackgroundLabel no whole number"
      : this->isAnyChosen() && this->counts().empty() ? "no chosen label is there"
                                                      : "";
  }

  bool mustAccept() const override
  {
    return this->Parameters.areSensible() && this->whyRefuse().empty();
  }
  bool mayBeEmpty() const override { return this->counts().empty(); }

  void judge(std::size_t warnings) override
  {
    const std::map<double, double> counts = this->counts();
    vtkPolyData* output = this->Filter->GetOutput();
    const Surface all = surfaceOf(output);
    requireUsableFaces(all);
    requireClosed(topologyOf(all));
    vtkDataArray* values = output->GetFieldData()->GetArray("LabelValue");
    require(values && values->GetNumberOfTuples() == vtkIdType(counts.size()), Fault::Misstated,
      "LabelValue has not the ", counts.size(), " labels of the image");
    vtkIdType number = 0;
    for (const auto& [label, voxels] : counts)
    {
      requireStated("LabelValue", values->GetTuple1(number), label, 0.0);
      this->judgeLabel(label, voxels, number, all, warnings);
      ++number;
    }
    const std::int64_t crossings = intersectionsOf(surfaceOf(this->interfaces()));
    require(crossings == 0, Fault::SelfIntersections, crossings, " pairs of triangles intersect");
  }

private:
  vtkPolyData* interfaces()
  {
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
  }

  bool isBackgroundWhole() const
  {
    const double background = this->Filter->GetBackgroundLabel();
    return background == std::floor(background);
  }

  bool isAnyChosen() const { return this->Filter->GetNumberOfLabels() > 0; }

  bool isWanted(double label) const
  {
    return label != this->Filter->GetBackgroundLabel() &&
      (!this->isAnyChosen() || label == this->Filter->GetLabel(0));
  }

  /// The voxels of every label that gets a surface.
  std::map<double, double> counts() const
  {
    std::map<double, double> counts;
    for (const double label : this->Labels.values)
    {
      if (this->isWanted(label))
      {
        counts[label] += 1.0;
      }
    }
    return counts;
  }

  void judgeLabel(
    double label, double voxels, vtkIdType number, const Surface& all, std::size_t warnings)
  {
    vtkPolyData* output = this->Filter->GetOutput();
    vtkDataArray* labels = output->GetCellData()->GetArray("Label");
    vtkDataArray* neighbors = output->GetCellData()->GetArray("NeighborLabel");
    Surface one{ all.points, {}, {} };
    for (std::size_t f = 0; f < all.faces.size(); ++f)
    {
      if (labels->GetTuple1(all.cellOfFace[f]) == label)
      {
        require(neighbors->GetTuple1(all.cellOfFace[f]) != label, Fault::Misstated,
          "NeighborLabel is the label itself");
        one.faces.push_back(all.faces[f]);
        one.cellOfFace.push_back(all.cellOfFace[f]);
      }
    }
    requireClosed(topologyOf(one));
    requireOutward(one);
    const double wanted = voxels * this->Labels.voxelVolume();
    const double volume = volumeOf(one, middleOf(one));
    const double said = output->GetFieldData()->GetArray("Volume")->GetComponent(number, 0);
    requireStated("Volume", said, volume, 1e-3 * wanted);
    require(warnings > 0 || std::abs(volume - wanted) <= VolumeError * wanted, Fault::NoVolume,
      "label ", label, " has the volume ", volume, ", its voxels ", wanted);
    for (const Cell& face : one.faces)
    {
      const Vec3 place = this->Labels.inVoxels(all.corner(face, 0));
      const double distance = this->Labels.distanceToFaces(label, place);
      require(distance <= MostDistance, Fault::TooFar, "a point of label ", label, " is ", distance,
        " voxels from its voxels' faces");
    }
  }

  LabelModel Labels;
  vtkNew<vtkLabelSurfaces> Filter;
};

} // namespace

std::unique_ptr<FilterCase> makeLabelCase(const Subject& subject, Random& random)
{
  return std::make_unique<LabelCase>(subject, random);
}

} // namespace robustness
