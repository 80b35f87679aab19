// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Arguments.h"

#include "FilterCase.h"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>

namespace robustness
{

namespace
{

[[noreturn]] void refuse(const std::string& sentence)
{
  std::cerr << sentence << "\n";
  std::exit(2);
}

std::uint64_t number(const std::string& option, const std::string& text)
{
  const bool hasDigitsOnly =
    !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  if (!hasDigitsOnly || text.size() > 18)
  {
    refuse(option + " was given '" + text + "'; expected a whole number from 0 on.");
  }
  return std::stoull(text);
}

void printUsage()
{
  std::cout
    << "Sends inputs made from seeds through the filters, each in a process of its own, and judges "
       "the answers.\n\n"
       "RobustnessRunner [options]\n"
       "  --seed FIRST       the first seed (1)\n"
       "  --count N          inputs (300); 0 goes on until the time is up\n"
       "  --seconds S        ends after so many seconds (0: not before all inputs are done)\n"
       "  --jobs N           processes at once (0: as many as there are cores)\n"
       "  --time-limit S     processor seconds of an input (60)\n"
       "  --only FILTER      one filter for all inputs:";
  for (const FilterKind& kind : filterKinds())
  {
    std::cout << " " << kind.name;
  }
  std::cout << "\n  --show OUTCOME     prints the inputs that are valid, refused or have a "
               "shortcoming too\n"
               "  --repeat SEED      one input in this process, described in full\n"
               "  --save FILE.vtp    with --repeat: writes the input\n\n"
               "The exit status is 1 when an answer is wrong, or an input crashes, takes too long "
               "or too much memory.\n";
}

int smallNumber(const std::string& option, const std::string& text)
{
  const std::uint64_t value = number(option, text);
  if (value > 1000000)
  {
    refuse(option + " was given " + text + "; expected at most 1000000.");
  }
  return static_cast<int>(value);
}

void set(Arguments& arguments, const std::string& option, const std::string& value)
{
  const std::map<std::string, std::function<void()>> setters{
    { "--seed", [&]() { arguments.seed = number(option, value); } },
    { "--count", [&]() { arguments.count = number(option, value); } },
    { "--seconds", [&]() { arguments.seconds = smallNumber(option, value); } },
    { "--jobs", [&]() { arguments.jobs = smallNumber(option, value); } },
    { "--time-limit", [&]() { arguments.timeLimit = smallNumber(option, value); } },
    { "--only", [&]() { arguments.only = filterKind(value).name; } },
    { "--repeat", [&]() { arguments.repeat = number(option, value); } },
    { "--save", [&]() { arguments.save = value; } }, { "--show", [&]() { arguments.show = value; } }
  };
  const auto setter = setters.find(option);
  if (setter == setters.end())
  {
    refuse("There is no option " + option + "; see --help.");
  }
  setter->second();
}

} // namespace

Arguments readArguments(int argc, char** argv)
{
  Arguments arguments;
  for (int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    if (option == "--help" || option == "-h")
    {
      printUsage();
      std::exit(0);
    }
    if (i + 1 == argc)
    {
      refuse(option + " needs a value, or is no option; see --help.");
    }
    try
    {
      set(arguments, option, argv[++i]);
    }
    catch (const std::invalid_argument& error)
    {
      refuse(error.what());
    }
  }
  if (arguments.count == 0 && arguments.seconds == 0)
  {
    refuse("Without an end it would never print its table; give --count or --seconds.");
  }
  return arguments;
}

} // namespace robustness
