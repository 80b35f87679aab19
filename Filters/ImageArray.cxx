// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageArray.h"

#include "KernelBridge.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"

#include <sstream>
#include <string>

namespace
{

//------------------------------------------------------------------------------
/// "a", "b" of the points and "c" of the cells.
std::string NamesOfArrays(vtkImageData* image)
{
  std::ostringstream names;
  for (const int where : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* data = image->GetAttributes(where);
    const char* elements = where == vtkDataObject::POINT ? " (points)" : " (cells)";
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* name = data->GetAbstractArray(i)->GetName();
      names << (names.tellp() > 0 ? ", \"" : "\"") << (name ? name : "") << "\"" << elements;
    }
  }
  return names.tellp() > 0 ? names.str() : "none";
}

//------------------------------------------------------------------------------
[[noreturn]] void Refuse(const std::string& what, const std::string& expected)
{
  throw evolving::InputError(what + ", expected " + expected + ".");
}

//------------------------------------------------------------------------------
struct Choice
{
  std::string Name; ///< empty: the active array of that role
  int Role = vtkDataSetAttributes::SCALARS;
  bool IsOfCells = false;
};

//------------------------------------------------------------------------------
vtkAbstractArray* FindIn(vtkDataSetAttributes* data, const Choice& choice)
{
  return choice.Name.empty() ? data->GetAbstractAttribute(choice.Role)
                             : data->GetAbstractArray(choice.Name.c_str());
}

//------------------------------------------------------------------------------
Choice ChoiceOf(vtkInformation* chosen, int port, vtkImageData* image)
{
  if (chosen->Get(vtkAlgorithm::INPUT_PORT()) != port)
  {
    Refuse("The array to process was chosen of input port " +
        std::to_string(chosen->Get(vtkAlgorithm::INPUT_PORT())),
      "port " + std::to_string(port) + ", where the image is");
  }
  const int where = chosen->Get(vtkDataObject::FIELD_ASSOCIATION());
  const char* name = chosen->Get(vtkDataObject::FIELD_NAME());
  const auto role = vtkDataObject::FIELD_ATTRIBUTE_TYPE();
  Choice choice;
  choice.Name = name ? name : ""; // ParaView sends an empty one where nothing was chosen
  choice.Role = chosen->Has(role) ? chosen->Get(role) : choice.Role;
  const bool isEither =
    choice.Name.empty() || where == vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;
  choice.IsOfCells = where == vtkDataObject::FIELD_ASSOCIATION_CELLS ||
    (isEither && !FindIn(image->GetPointData(), choice) && FindIn(image->GetCellData(), choice));
  return choice;
}

//------------------------------------------------------------------------------
vtkDataArray* Find(
  vtkImageData* image, const Choice& choice, const std::string& name, const std::string& expected)
{
  const int where = choice.IsOfCells ? vtkDataObject::CELL : vtkDataObject::POINT;
  vtkAbstractArray* array = FindIn(image->GetAttributes(where), choice);
  const std::string elements = choice.IsOfCells ? "cell" : "point";
  if (!array)
  {
    Refuse(choice.Name.empty()
        ? name + " has no active " + vtkDataSetAttributes::GetAttributeTypeAsString(choice.Role)
        : name + " has no " + elements + " array \"" + choice.Name + "\"",
      expected + "; choose one of its arrays: " + NamesOfArrays(image));
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers || numbers->GetNumberOfComponents() != 1)
  {
    const std::string ofArray = array->GetName() ? array->GetName() : "";
    Refuse("The " + elements + " array \"" + ofArray + "\" of the image has " +
        (numbers ? std::to_string(numbers->GetNumberOfComponents()) + " components"
                 : std::string("values that are no numbers")),
      "one number for each " + elements +
        "; choose another array, or make a magnitude or a component of it with Calculator");
  }
  return numbers;
}

//------------------------------------------------------------------------------
/// The middles of an image's cells; along an axis of a single sample, that sample.
void SetToMiddles(vtkImageData* image, vtkImageData* middles)
{
  int extent[6];
  image->GetExtent(extent);
  double first[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool hasCells = extent[2 * axis] < extent[2 * axis + 1];
    first[axis] = hasCells ? 0.5 : 0.0;
    extent[2 * axis + 1] -= hasCells ? 1 : 0;
  }
  double origin[3];
  image->TransformContinuousIndexToPhysicalPoint(first[0], first[1], first[2], origin);
  middles->SetExtent(extent);
  middles->SetOrigin(origin);
}

} // namespace

//------------------------------------------------------------------------------
ImageArray::ImageArray(vtkAlgorithm* filter, int port, const char* expected)
  : Port(port)
  , Expected(expected)
{
  filter->SetInputArrayToProcess(
    0, port, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
ImageArray::~ImageArray() = default;

//------------------------------------------------------------------------------
vtkImageData* ImageArray::Get(vtkAlgorithm* filter, vtkInformationVector** inputVector)
{
  vtkImageData* image = vtkImageData::GetData(inputVector[this->Port]);
  if (!image)
  {
    return nullptr;
  }
  const Choice choice = ChoiceOf(filter->GetInputArrayInformation(0), this->Port, image);
  const char* name = this->Port == 0 ? "The image" : "The image on the second input";
  vtkDataArray* array = Find(image, choice, name, this->Expected);
  if (!this->Samples || image != this->LastImage || image->GetMTime() != this->LastTime ||
    array != this->LastArray)
  {
    this->Samples = vtkSmartPointer<vtkImageData>::New();
    this->Samples->CopyStructure(image);
    if (choice.IsOfCells)
    {
      SetToMiddles(image, this->Samples);
    }
    this->Samples->GetPointData()->SetScalars(array);
    this->LastImage = image;
    this->LastTime = image->GetMTime();
    this->LastArray = array;
  }
  return this->Samples;
}
