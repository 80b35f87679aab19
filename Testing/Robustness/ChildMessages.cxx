// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChildMessages.h"

#include <unistd.h>

#include <algorithm>
#include <sstream>

namespace robustness
{

namespace
{

std::string field(std::istringstream& line)
{
  std::string text;
  std::getline(line, text, '\t');
  return text;
}

} // namespace

void Messenger::send(std::string line) const
{
  std::replace(line.begin(), line.end(), '\n', ' ');
  line += '\n';
  for (std::size_t sent = 0; sent < line.size();)
  {
    const ssize_t part = write(this->Pipe, line.data() + sent, line.size() - sent);
    if (part <= 0)
    {
      _exit(1); // nobody listens any more
    }
    sent += static_cast<std::size_t>(part);
  }
}

void Messenger::describe(const std::string& text) const
{
  this->send("D\t" + text);
}

void Messenger::conclude(const Verdict& verdict) const
{
  this->send("V\t" + std::to_string(static_cast<int>(verdict.outcome)) + "\t" +
    std::to_string(static_cast<int>(verdict.fault)) + "\t" + verdict.what);
}

bool readTold(const std::string& told, ChildResult& result)
{
  std::istringstream stream(told);
  bool hasVerdict = false;
  for (std::string text; std::getline(stream, text);)
  {
    std::istringstream line(text);
    const std::string kind = field(line);
    if (kind == "D")
    {
      result.description = field(line);
    }
    else if (kind == "V")
    {
      result.verdict.outcome = static_cast<Outcome>(std::stoi(field(line)));
      result.verdict.fault = static_cast<Fault>(std::stoi(field(line)));
      result.verdict.what = field(line);
      hasVerdict = true;
    }
  }
  return hasVerdict;
}

} // namespace robustness
