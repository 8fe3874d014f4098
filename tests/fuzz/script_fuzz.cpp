// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: what users and scripts hand over as text: names of filters, parameters, values in single precision, command
// lines of the runner. Either refused in words, or read; and a filter script says what it was written from.
#include <cstring>

#include "filter_script.h"
#include "fuzz/byte_reader.h"
#include "fuzz/invariants.h"
#include "fuzz/read_script.h"
#include "registry.h"
#include "runner/command_line.h"
#include "runner/exit_status.h"

namespace {

using namespace integral_invariant::filter;
using integral_invariant::InputError;

/// The arguments that the text stands for. None holds a zero: programs cannot be handed one.
std::vector<std::string> arguments_in(const std::string& text)
{
  std::vector<std::string> arguments(1);
  for (const char c : text) {
    if (c == '\0')
      arguments.emplace_back();
    else
      arguments.back() += c;
  }
  return arguments;
}

/// Whether `action` was not refused; a refusal has a sentence.
template <class Action>
bool is_taken(const Action& action)
{
  try {
    action();
    return true;
  } catch (const InputError& error) {
    fuzz::require_sentence(error);
  } catch (const runner::Failure& failure) {
    fuzz::require_sentence(failure);
  }
  return false;
}

/// As hosts do that keep numbers in single precision.
void store_single(fuzz::ByteReader& bytes, const Filter& filter, Request& request)
{
  const std::vector<ParameterSpec>& rows = filter.parameters;
  const ParameterSpec& spec = rows[bytes.below(std::uint32_t(rows.size()))];
  std::uint8_t raw[4];
  for (std::uint8_t& byte : raw) byte = bytes.byte();
  float value;
  std::memcpy(&value, raw, sizeof value);
  if (spec.kind == Kind::save_file) return;
  if (!is_taken([&] { store(spec, undo_float_rounding(value), request); })) return;
  fuzz::require(spec.get(request) == undo_float_rounding(value), "a value that is stored can be read");
  fuzz::require(float(undo_float_rounding(value)) == value,
                "a typed number is the one that was kept in single precision");
}

void require_same(const Request& written, const Request& read, const Filter& filter)
{
  for (const ParameterSpec& spec : filter.parameters) {
    if (spec.kind == Kind::save_file)
      fuzz::require(spec.get_text(written) == spec.get_text(read), "a script has the file name it was written from");
    else
      fuzz::require(spec.get(written) == spec.get(read), "a script has the values that it was written from");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::ByteReader bytes(data, size);
  const Filter& filter = *all_filters()[bytes.below(std::uint32_t(all_filters().size()))];
  Request request;
  for (std::uint32_t i = bytes.below(4); i > 0; --i) store_single(bytes, filter, request);
  const std::vector<std::string> arguments = arguments_in(bytes.rest());
  for (const std::string& argument : arguments) is_taken([&] { store_assignment(filter, argument, request); });
  is_taken([&] { find_filter(arguments.front()); });
  is_taken([&] { runner::parse_command_line(arguments); });

  std::string text;
  if (!is_taken([&] { text = filter_script(filter, request); })) return 0;
  const fuzz::ReadScript script = fuzz::read_script(text);
  fuzz::require(&find_filter(script.filter) == &filter, "a script names its filter");
  Request read;
  for (const std::string& assignment : script.assignments)
    fuzz::require(is_taken([&] { store_assignment(filter, assignment, read); }), "what a script says is permitted");
  require_same(request, read, filter);
  return 0;
}
