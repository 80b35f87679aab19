// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Arguments.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace benchmark
{

namespace
{

[[noreturn]] void refuse(const std::string& sentence)
{
  std::cerr << sentence << "\n";
  std::exit(2);
}

int integer(const std::string& option, const std::string& text, int lowest)
{
  std::size_t end = 0;
  int value = lowest - 1;
  try
  {
    value = std::stoi(text, &end);
  }
  catch (const std::exception&)
  {
    end = 0;
  }
  if (end != text.size() || text.empty() || value < lowest)
  {
    refuse(option + " was given '" + text + "'; expected a number of at least " +
      std::to_string(lowest) + ".");
  }
  return value;
}

std::vector<int> integers(const std::string& option, const std::string& text, int lowest)
{
  std::vector<int> values;
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ',');)
  {
    values.push_back(integer(option, item, lowest));
  }
  if (values.empty())
  {
    refuse(option + " needs numbers with commas between them.");
  }
  return values;
}

bool isModel(const std::filesystem::path& file)
{
  static const std::vector<std::string> endings{ ".obj", ".ply", ".stl", ".vtk", ".vtp" };
  return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

/// A file, or the meshes of a folder by name.
void addModels(const std::string& path, std::vector<std::string>& models)
{
  if (!std::filesystem::is_directory(path))
  {
    if (!std::filesystem::exists(path))
    {
      refuse("There is no file or folder '" + path + "'.");
    }
    models.push_back(path);
    return;
  }
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(path))
  {
    if (entry.is_regular_file() && isModel(entry.path()))
    {
      found.push_back(entry.path().string());
    }
  }
  std::sort(found.begin(), found.end());
  models.insert(models.end(), found.begin(), found.end());
}

void printUsage(const std::string& program, const Arguments& defaults, const std::string& purpose)
{
  std::cout << purpose << "\n\n"
            << std::filesystem::path(program).filename().string()
            << " [--sizes N,N,...] [--threads N] [--runs N] [--subdivisions N]";
  for (const auto& [name, isOn] : defaults.switches)
  {
    std::cout << " [" << name << "]";
  }
  std::cout << " [MESH or FOLDER ...]\n\n"
            << "MESH is .obj, .ply, .stl, .vtk or .vtp; without one it is "
            << (defaults.models.empty() ? "Data/bunny.ply" : "all of Data") << ".\n";
}

/// @param paths those of the command line, or none
std::vector<std::string> modelsAt(std::vector<std::string> paths, const Arguments& defaults)
{
  if (paths.empty())
  {
    paths = defaults.models;
  }
  if (paths.empty())
  {
    paths.push_back(dataFolder() + "/bunny.ply");
  }
  std::vector<std::string> models;
  for (const std::string& path : paths)
  {
    addModels(path, models);
  }
  return models;
}

void setOption(Arguments& arguments, const std::string& option, const std::string& value)
{
  if (option == "--sizes")
  {
    arguments.sizes = integers(option, value, 2);
  }
  else if (option == "--threads")
  {
    arguments.threads = integer(option, value, 1);
  }
  else if (option == "--runs")
  {
    arguments.runs = integer(option, value, 1);
  }
  else if (option == "--subdivisions")
  {
    arguments.subdivisions = integer(option, value, 0);
  }
  else
  {
    refuse("There is no option " + option + "; see --help.");
  }
}

} // namespace

std::string dataFolder()
{
  return EVOLVINGSURFACES_DATA_DIR;
}

Arguments readArguments(
  int argc, char** argv, const Arguments& defaults, const std::string& purpose)
{
  Arguments arguments = defaults;
  std::vector<std::string> paths;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--help" || word == "-h")
    {
      printUsage(argv[0], defaults, purpose);
      std::exit(0);
    }
    if (word.rfind("--", 0) != 0)
    {
      paths.push_back(word);
    }
    else if (arguments.switches.count(word) > 0)
    {
      arguments.switches[word] = true;
    }
    else if (i + 1 < argc)
    {
      setOption(arguments, word, argv[++i]);
    }
    else
    {
      refuse(word + " needs a value, or is no option; see --help.");
    }
  }
  arguments.models = modelsAt(paths, defaults);
  return arguments;
}

} // namespace benchmark
