// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trial.h"

#include "Generator.h"
#include "OutputChecks.h"

#include "DataChecks.h"
#include "EventLog.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"

#include <new>

namespace robustness
{

namespace
{

bool saysOutOfMemory(const std::string& sentence)
{
  return sentence.find("out of memory") != std::string::npos ||
    sentence.find("do not fit into memory") != std::string::npos;
}

bool hasStopped(FilterCase& filterCase)
{
  return filterCase.filter()->GetOutputDataObject(0)->GetFieldData()->HasArray("Stopped") != 0;
}

/// Exactly one sentence, and outputs as new; or a flow that stopped, with what it reached.
Verdict judgeError(FilterCase& filterCase, const std::string& sentence, std::size_t warnings)
{
  if (saysOutOfMemory(sentence))
  {
    return { Outcome::OutOfMemory, Fault::None, sentence };
  }
  require(bool(IsOneSentence(sentence)), Fault::NoSentence, "\"", sentence, "\"");
  if (hasStopped(filterCase))
  {
    filterCase.requireNumbers();
    filterCase.judge(warnings);
    return { Outcome::Shortcoming, Fault::None, sentence };
  }
  for (int port = 0; port < filterCase.filter()->GetNumberOfOutputPorts(); ++port)
  {
    const auto isNew = IsInitialized(filterCase.filter()->GetOutputDataObject(port));
    require(bool(isNew), Fault::LeftOver, "in spite of \"", sentence, "\" ", isNew.message());
  }
  require(!filterCase.mustAccept(), Fault::RefusedGood, sentence);
  return { Outcome::Refused, Fault::None, sentence };
}

Verdict judgeResult(FilterCase& filterCase, const std::vector<std::string>& warnings)
{
  const std::string why = filterCase.whyRefuse();
  require(why.empty(), Fault::AcceptedBad, "no error, though ", why);
  require(
    !hasStopped(filterCase) || !warnings.empty(), Fault::NoSentence, "it stopped without a word");
  auto* output = vtkDataSet::SafeDownCast(filterCase.filter()->GetOutputDataObject(0));
  if (output->GetNumberOfPoints() == 0)
  {
    require(filterCase.mayBeEmpty(), Fault::Nothing, "the output is empty, without a word");
    return {};
  }
  filterCase.requireNumbers();
  filterCase.judge(warnings.size());
  return warnings.empty() ? Verdict()
                          : Verdict{ Outcome::Shortcoming, Fault::None, warnings.front() };
}

Verdict judgeEvents(FilterCase& filterCase, const EventLog& log)
{
  require(log.Others.empty(), Fault::NoSentence, "something else says \"",
    log.Others.empty() ? "" : log.Others.front(), "\"");
  require(log.Errors.size() <= 1, Fault::NoSentence, log.Errors.size(), " errors, the first \"",
    log.Errors.empty() ? "" : log.Errors.front(), "\"");
  return log.Errors.empty() ? judgeResult(filterCase, log.Warnings)
                            : judgeError(filterCase, log.Errors.front(), log.Warnings.size());
}

} // namespace

Verdict judgeAnswer(FilterCase& filterCase)
{
  EventLog log(filterCase.filter());
  try
  {
    filterCase.update();
  }
  catch (const std::bad_alloc&)
  {
    return { Outcome::OutOfMemory, Fault::None, "std::bad_alloc left the filter" };
  }
  catch (const std::exception& error)
  {
    return { Outcome::Wrong, Fault::NoSentence,
      std::string("an exception left the filter: ") + error.what() };
  }
  try
  {
    return judgeEvents(filterCase, log);
  }
  catch (const WrongAnswer& answer)
  {
    return { Outcome::Wrong, answer.fault(), answer.what() };
  }
}

Verdict runTrial(std::uint64_t seed, const FilterKind& kind,
  const std::function<void(const std::string&)>& describe)
{
  const Subject subject(makeModel(seed));
  Random random(seed, Random::ForParameters);
  const auto filterCase = kind.make(subject, random);
  describe(subject.model.describe() + " | " + kind.name + ": " + filterCase->describe());
  return judgeAnswer(*filterCase);
}

} // namespace robustness
