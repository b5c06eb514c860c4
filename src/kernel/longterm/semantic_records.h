// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/longterm/activations.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"

/// What semantic memory writes into its journal: the whole of it as an image, and one record per change. Constants
/// stand in records as such, objects as their numbers, so that a record says the same wherever it is read.
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

/// Does again what the record tells. False if it makes no sense here; what has been done by then is left as it is.
bool Apply(std::string_view record, Knowledge& knowledge, Activations& activations, LinkWeights& weights);
bool ReadImage(std::string_view image, Knowledge& knowledge, Activations& activations, LinkWeights& weights);

}  // namespace soarbox::kernel::records
