// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_records.h"

#include "bytes/byte_stream.h"

namespace soarbox::kernel {
namespace {

/// The first byte of a constant's record.
enum class ConstantKind : std::uint8_t { kText = 1, kInteger, kFloat };

void WriteConstant(ByteWriter& out, const EpisodeTerms& terms, EpisodeTerm term) {
  switch (terms.kind(term)) {
    case TermKind::kInteger:
      out.Byte(static_cast<std::uint8_t>(ConstantKind::kInteger));
      out.Fixed64(static_cast<std::uint64_t>(terms.Integer(term)));
      break;
    case TermKind::kFloat:
      out.Byte(static_cast<std::uint8_t>(ConstantKind::kFloat));
      out.Double(terms.Float(term));
      break;
    default:
      out.Byte(static_cast<std::uint8_t>(ConstantKind::kText));
      out.Text(terms.Text(term));
      break;
  }
}

/// Returns false if the record is invalid: an existing constant must not get a new number.
bool ReadConstant(ByteReader& in, EpisodeTerms& terms) {
  const std::size_t next = terms.size();
  switch (static_cast<ConstantKind>(in.Byte())) {
    case ConstantKind::kText:
      return terms.Intern(in.Text()) == next && !in.failed();
    case ConstantKind::kInteger:
      return terms.Intern(static_cast<std::int64_t>(in.Fixed64())) == next && !in.failed();
    case ConstantKind::kFloat:
      return terms.Intern(in.Double()) == next && !in.failed();
  }
  return false;
}

bool ReadFact(ByteReader& in, EpisodeStore& store, const EpisodeTerms& terms) {
  const std::uint64_t parent = in.Number(), attribute = in.Number(), value = in.Number();
  if (in.failed() || parent >= store.node_count() || attribute >= terms.size()) return false;
  // Nodes are numbered in the order in which facts first refer to them.
  const bool is_node = value % 2 == 1;
  if (value / 2 >= (is_node ? store.node_count() + std::uint64_t{1} : terms.size())) return false;
  const auto index = static_cast<std::uint32_t>(value / 2);
  const std::size_t next = store.fact_count();
  return store.Intern({static_cast<EpisodeNode>(parent), static_cast<EpisodeTerm>(attribute),
                       is_node ? EpisodeValue::Node(index) : EpisodeValue::Constant(index)}) == next;
}

bool ReadEpisode(ByteReader& in, EpisodeStore& store, EpisodeTerms& terms) {
  for (std::uint64_t n = in.Number(); n > 0; --n) {
    if (!ReadConstant(in, terms)) return false;
  }
  for (std::uint64_t n = in.Number(); n > 0; --n) {
    if (!ReadFact(in, store, terms)) return false;
  }
  for (std::uint64_t n = in.Number(); n > 0; --n) {
    const std::uint64_t node = in.Number(), lti = in.Number();
    if (in.failed() || node >= store.node_count()) return false;
    store.SetLink(static_cast<EpisodeNode>(node), lti);
  }
  for (std::uint64_t n = in.Number(); n > 0; --n) {
    const std::uint64_t change = in.Number();
    if (in.failed() || change / 2 >= store.fact_count()) return false;
    const auto fact = static_cast<EpisodeFact>(change / 2);
    const bool comes = change % 2 == 1;
    if (store.IsHeld(fact) == comes) return false;
    if (comes) {
      store.Hold(fact);
    } else {
      store.Release(fact);
    }
  }
  if (in.failed()) return false;
  store.Commit();
  return true;
}

}  // namespace

std::string EpisodeWriter::Write() {
  std::string bytes;
  ByteWriter out(bytes);
  while (episodes_written_ < store_.last()) {
    const EpisodeNumber episode = ++episodes_written_;
    out.Number(terms_.size() - terms_written_);
    for (; terms_written_ < terms_.size(); ++terms_written_) {
      WriteConstant(out, terms_, static_cast<EpisodeTerm>(terms_written_));
    }
    out.Number(store_.fact_count() - facts_written_);
    for (; facts_written_ < store_.fact_count(); ++facts_written_) {
      const EpisodeTriple triple = store_.triple(static_cast<EpisodeFact>(facts_written_));
      out.Number(triple.parent);
      out.Number(triple.attribute);
      out.Number(triple.value.IsNode() ? 2 * std::uint64_t{triple.value.node()} + 1
                                       : 2 * std::uint64_t{triple.value.term()});
    }
    const std::vector<std::pair<EpisodeNode, std::uint64_t>> links = store_.LinksOf(episode);
    out.Number(links.size());
    for (const auto& [node, lti] : links) {
      out.Number(node);
      out.Number(lti);
    }
    const std::span<const std::uint32_t> changes = store_.ChangesOf(episode);
    out.Number(changes.size());
    for (const std::uint32_t change : changes) out.Number(change);
  }
  return bytes;
}

void EpisodeWriter::SkipAll() {
  terms_written_ = terms_.size();
  facts_written_ = store_.fact_count();
  episodes_written_ = store_.last();
}

bool ReadEpisodes(std::string_view bytes, EpisodeStore& store, EpisodeTerms& terms) {
  ByteReader in(bytes);
  while (!in.AtEnd()) {
    if (!ReadEpisode(in, store, terms)) return false;
  }
  return !in.failed();
}

}  // namespace soarbox::kernel
