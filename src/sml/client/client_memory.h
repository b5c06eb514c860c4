// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sml/client/link.h"
#include "sml/client/object_pool.h"
#include "sml/client/sml_ClientIdentifier.h"
#include "sml/client/sml_DeltaList.h"
#include "sml/client/sml_OutputDeltaList.h"
#include "sml/server/tag_map.h"

namespace sml {

struct AgentData;

/// The elements of one agent from the view of one client: its input, and the output that it received.
///
/// Elements are reused: in the steady state nothing is allocated.
class WorkingMemory {
 public:
  explicit WorkingMemory(AgentData& data) : data_(data), life_(NewLife()), last_life_(life_) {
    // Reserved for a few commands, so that the first ticks do not allocate more than later ones.
    changes_.deltas_.reserve(kUsualChanges);
    removed_.reserve(kUsualChanges);
    releasing_.reserve(kUsualChanges);
    work_.reserve(kUsualChanges);
  }
  ~WorkingMemory();

  // Input -----------------------------------------------------------------------------------------------------------

  /// Returns null, with an error, if the kernel does not answer.
  Identifier* InputLink();
  StringElement* CreateString(Identifier* parent, char const* attribute, char const* value);
  IntElement* CreateInt(Identifier* parent, char const* attribute, long long value);
  FloatElement* CreateFloat(Identifier* parent, char const* attribute, double value);
  Identifier* CreateId(Identifier* parent, char const* attribute);
  Identifier* CreateSharedId(Identifier* parent, char const* attribute, Identifier* shared);
  void Update(StringElement* wme, char const* value);
  void Update(IntElement* wme, long long value);
  void Update(FloatElement* wme, double value);
  bool Destroy(WMElement* wme);
  bool Commit();
  bool IsCommitRequired() const { return !pending_.changes_.empty(); }
  /// Sends the entire input again, after init-soar.
  void Refresh();
  bool SynchronizeInput();

  // Output ----------------------------------------------------------------------------------------------------------

  Identifier* OutputLink() { return output_link_; }
  void EnableTracking(bool by_user);
  void DisableTracking();
  bool tracking() const { return tracking_ == Tracking::kOn; }
  /// Clears the list of changes if an apply phase has ended since they arrived.
  void DropOldChanges();
  void ClearChanges();
  OutputDeltaList& changes() { return changes_; }
  int CountCommands();
  Identifier* Command(int index);

  void BeginOutput();
  void ReceiveOutput(const OutputWme& wme);
  /// Adds an element of the output. Returns false if its parent is unknown (yet).
  bool AddOutput(const OutputWme& wme);
  void RemoveOutput(long long tag);
  /// Attaches the elements that waited for their parent. Returns true if all parents exist.
  bool EndOutput() { return orphans_.empty() || AttachOrphans(); }
  /// init-soar: the output was removed.
  void InvalidateOutput();
  bool SynchronizeOutput();

  /// A number that is unique among all working memories of this process. Its elements use the numbers that follow
  /// (WMElement::GetLife).
  unsigned long long life() const { return life_; }

  /// Returns true if it is a live element of this agent.
  bool Owns(const WMElement* wme) const;
  IdentifierSymbol* FindSymbol(long long key);

 private:
  friend class IdentifierSymbol;
  static constexpr std::size_t kUsualChanges = 16;
  enum class Tracking { kAutoOff, kUserOff, kOn };

  Agent& agent() const;
  bool CheckParent(Identifier* parent, char const*& attribute);
  bool CheckUpdate(WMElement* wme);
  void Attach(WMElement* wme, IdentifierSymbol* parent, std::string_view attribute, long long tag, bool output);
  void Detach(WMElement* wme);
  void Release(WMElement* wme);
  void DropSymbol(Identifier* identifier, std::vector<WMElement*>& below);
  void RetireElement(WMElement* wme);
  IdentifierSymbol* NewSymbol(std::string_view name, long long key);
  IdentifierSymbol* SymbolFor(long long key);
  void SendNew(WMElement* wme);
  void SendUpdated(WMElement* wme);
  static soarbox::server::InputWme Describe(WMElement* wme);
  WMElement* MakeOutput(const OutputWme& wme, IdentifierSymbol* parent);
  static bool HasOwn(IdentifierSymbol& parent, const OutputWme& wme);
  bool AttachOrphans();
  bool Cancel(long long tag);
  void ReleaseBelow(IdentifierSymbol* symbol);
  std::string NewName(char const* attribute);

  static unsigned long long NewLife();

  AgentData& data_;
  const unsigned long long life_;
  unsigned long long last_life_;
  Identifier* input_link_ = nullptr;
  Identifier* output_link_ = nullptr;
  DeltaList pending_;
  OutputDeltaList changes_;
  Tracking tracking_ = Tracking::kAutoOff;
  unsigned long long changes_at_ = 0;  ///< Number of apply phases when the last change arrived.
  std::vector<WMElement*> removed_;    ///< Removed output that is still in the list of changes.
  std::vector<WMElement*> releasing_;  ///< Those that ClearChanges is releasing.
  std::vector<WMElement*> work_;       ///< Elements that Release still has to process.
  struct Orphan {
    OutputWme wme;
    std::string attribute, text;
  };
  std::vector<Orphan> orphans_;
  std::vector<Orphan> waiting_orphans_;  ///< Those that EndOutput tries again.

  ObjectPool<StringElement> strings_;
  ObjectPool<IntElement> ints_;
  ObjectPool<FloatElement> floats_;
  ObjectPool<Identifier> identifiers_;
  ObjectPool<IdentifierSymbol> symbols_;
  soarbox::server::TagMap<WMElement*> output_by_tag_;
  soarbox::server::TagMap<IdentifierSymbol*> symbols_by_key_;
};

}  // namespace sml
