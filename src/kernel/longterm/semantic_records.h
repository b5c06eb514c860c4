// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/longterm/activations.h"
#include "kernel/longterm/journal.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"

/// What semantic memory writes into its journal: the whole of it as an image, and one record per change. Constants
/// stand in records as such, objects as their numbers, so that a record says the same wherever it is read.
namespace soarbox::kernel::records {

std::vector<std::uint8_t> Object(Lti number);
std::vector<std::uint8_t> NewObject(Lti number);
std::vector<std::uint8_t> NextNumber(Lti number);
std::vector<std::uint8_t> Edge(const Knowledge& knowledge, std::uint32_t object, StoreTerm attribute, StoreTerm value,
                               bool added);
std::vector<std::uint8_t> Alias(std::string_view name, Lti number);
std::vector<std::uint8_t> Touch(Lti number, bool advance);
std::vector<std::uint8_t> Clear();
std::vector<std::uint8_t> Weights(const Knowledge& knowledge, std::uint32_t object,
                                  const LinkWeights::Weights& weights);
void WriteImage(RecordWriter& out, const Knowledge& knowledge, const Activations& activations,
                const LinkWeights& weights);

/// Does again what the record tells. False if it makes no sense here; what has been done by then is left as it is.
bool Apply(std::span<const std::uint8_t> record, Knowledge& knowledge, Activations& activations, LinkWeights& weights);
bool ReadImage(std::span<const std::uint8_t> image, Knowledge& knowledge, Activations& activations,
               LinkWeights& weights);

}  // namespace soarbox::kernel::records
