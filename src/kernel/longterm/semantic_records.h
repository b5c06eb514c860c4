// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/longterm/activations.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"

/// The records that semantic memory writes to its journal: an image of the entire memory, and one record per change.
/// Records contain constants as values and objects as numbers, so that their meaning does not depend on the agent.
namespace soarbox::kernel::records {

std::string Object(Lti number);
std::string NewObject(Lti number);
std::string NextNumber(Lti number);
std::string Edge(const Knowledge& knowledge, std::uint32_t object, StoreTerm attribute, StoreTerm value, bool added);
std::string Alias(std::string_view name, Lti number);
std::string Touch(Lti number, bool advance);
std::string Clear();
std::string Weights(const Knowledge& knowledge, std::uint32_t object, const LinkWeights::Weights& weights);
std::string Image(const Knowledge& knowledge, const Activations& activations, const LinkWeights& weights);

/// Repeats the change in the record. Returns false if the record is invalid; changes before the error remain.
bool Apply(std::string_view record, Knowledge& knowledge, Activations& activations, LinkWeights& weights);
bool ReadImage(std::string_view image, Knowledge& knowledge, Activations& activations, LinkWeights& weights);

}  // namespace soarbox::kernel::records
