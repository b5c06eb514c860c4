// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "mind/event.h"

namespace soarbox::mind {

/// Writes the input link of one agent: the only interface through which a world changes what a mind perceives. The next
/// input phase applies the changes in the order of the calls.
///
/// Handles identify objects and elements; 0 is none. A handle of a removed element has no effect. Texts and attributes
/// end at the first zero byte. An element without an attribute is not added.
class InputWriter {
 public:
  using Handle = std::uint64_t;
  virtual ~InputWriter() = default;

  /// The object of the input link; 0 if the kernel no longer answers.
  virtual Handle InputLink() = 0;
  /// Adds an element to an object and returns its handle; 0 if it could not be added.
  virtual Handle Add(Handle object, std::string_view attribute, const Value& value) = 0;
  /// Adds a new object. `made` is set to the handle of the object.
  virtual Handle AddObject(Handle object, std::string_view attribute, Handle& made) = 0;
  /// Adds a link to an object that exists.
  virtual Handle AddLink(Handle object, std::string_view attribute, Handle to) = 0;
  /// Replaces an element by one with another value of the same type. The handle stays valid.
  virtual void Change(Handle element, const Value& value) = 0;
  /// Removes an element, and everything below it that nothing else leads to.
  virtual void Remove(Handle element) = 0;
};

}  // namespace soarbox::mind
