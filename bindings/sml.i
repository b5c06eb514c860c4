// SPDX-License-Identifier: BSD-2-Clause
// The parts of the client API that are the same for all languages. The file of a language includes this file, after it
// has defined
//
//   %soarbox_shared(TYPE)   how objects of the library (kernels, agents, elements) are passed: as shared pointers (life.h)
//   %soarbox_after_shared   exceptions to this rule
//
// and how calls are made (%exception, call.h).

%include <std_string.i>

#define SOARBOX_PUBLIC_API_ONLY
#define EXPORT

%header %{
#include "call.h"
#include "soarbox_ClientLog.h"
%}

// Functions that are only for C++, or that have arguments which cannot be passed.
%ignore sml::EventHandlerPlusData;
%ignore sml::WMElement::GetValueAsString(std::string&) const;
%ignore sml::StringElement::GetValueAsString(std::string&) const;
%ignore sml::IntElement::GetValueAsString(std::string&) const;
%ignore sml::FloatElement::GetValueAsString(std::string&) const;
%ignore sml::Identifier::GetValueAsString(std::string&) const;
%ignore sml::WMElement::DebugString;
%ignore sml::Identifier::GetChildrenBegin;
%ignore sml::Identifier::GetChildrenEnd;
%ignore sml::IdentifierSymbol::SetIdentifierSymbol;
%ignore sml::IdentifierSymbol::SetAreChildrenModified;
%ignore sml::IdentifierSymbol::UsedBy;
%ignore sml::IdentifierSymbol::NoLongerUsedBy;
%ignore sml::IdentifierSymbol::IsFirstUser;
%ignore sml::IdentifierSymbol::AddChild;
%ignore sml::IdentifierSymbol::RemoveChild;
%ignore sml::IdentifierSymbol::TransferChildren;
%ignore sml::IdentifierSymbol::DeleteAllChildren;
%ignore sml::IdentifierSymbol::DebugString;
%ignore sml::Kernel::GetConnection;
%ignore sml::ClientAnalyzedXML::Attach;
%ignore soarxml::ElementXML::ElementXML(std::shared_ptr<const soarbox::wire::Element>);
%ignore soarxml::ElementXML::element;
%ignore soarxml::ElementXML::operator=;

// Recordings are not part of Soar's interface, but are useful in every language.
%extend sml::Kernel {
  // Returns the error, or an empty text.
  std::string Record(char const *pFile) { return soarbox::RecordClients(*$self, pFile ? pFile : ""); }
}

// Texts that C++ programs allocate and release: other languages have their own strings.
%define %soarbox_own_texts(TYPE)
%ignore TYPE::AllocateString;
%ignore TYPE::DeleteString;
%ignore TYPE::CopyString;
%ignore TYPE::CopyBuffer;
%ignore TYPE::GenerateXMLString;
%extend TYPE {
  %rename(GenerateXMLString) SoarboxXml;
  std::string SoarboxXml(bool includeChildren, bool insertNewLines = false) {
    char* text = $self->GenerateXMLString(includeChildren, insertNewLines);
    const std::string copy = text ? text : "";
    TYPE::DeleteString(text);
    return copy;
  }
}
%enddef
%soarbox_own_texts(soarxml::ElementXML)
%soarbox_own_texts(sml::ClientXML)
%soarbox_own_texts(sml::ClientAnalyzedXML)
%newobject soarxml::ElementXML::ParseXMLFromString;

// A part of the trace is a separate object, so that it outlives the object that it came from.
%ignore sml::ClientXML::ConvertToTraceXML;
%header %{
namespace {
struct OpenXml : sml::ClientXML {
  static soarxml::ElementXML const& Element(sml::ClientXML const& xml) { return xml.*(&OpenXml::element_); }
};
}  // namespace
%}
%extend sml::ClientXML {
  %rename(ConvertToTraceXML) SoarboxTrace;
  %newobject SoarboxTrace;
  sml::ClientTraceXML* SoarboxTrace() { return new sml::ClientTraceXML(OpenXml::Element(*$self)); }
}

// The parts of an answer, as separate objects that share its text.
%ignore sml::ClientAnalyzedXML::GetCommandTag;
%ignore sml::ClientAnalyzedXML::GetResultTag;
%ignore sml::ClientAnalyzedXML::GetErrorTag;
%define %soarbox_part(NAME)
%extend sml::ClientAnalyzedXML {
  %rename(NAME) Soarbox##NAME;
  %newobject Soarbox##NAME;
  soarxml::ElementXML* Soarbox##NAME() {
    soarxml::ElementXML const* part = $self->NAME();
    return part ? new soarxml::ElementXML(*part) : nullptr;
  }
}
%enddef
%soarbox_part(GetCommandTag)
%soarbox_part(GetResultTag)
%soarbox_part(GetErrorTag)

// Each language registers handlers in its own way.
%ignore RegisterForRunEvent;
%ignore RegisterForProductionEvent;
%ignore RegisterForPrintEvent;
%ignore RegisterForXMLEvent;
%ignore RegisterForOutputNotification;
%ignore AddOutputHandler;
%ignore RegisterForSystemEvent;
%ignore RegisterForUpdateEvent;
%ignore RegisterForStringEvent;
%ignore RegisterForAgentEvent;
%ignore AddRhsFunction;
%ignore RegisterForClientMessageEvent;
%ignore UnregisterForRunEvent;
%ignore UnregisterForProductionEvent;
%ignore UnregisterForPrintEvent;
%ignore UnregisterForXMLEvent;
%ignore UnregisterForOutputNotification;
%ignore RemoveOutputHandler;
%ignore UnregisterForSystemEvent;
%ignore UnregisterForUpdateEvent;
%ignore UnregisterForStringEvent;
%ignore UnregisterForAgentEvent;
%ignore RemoveRhsFunction;
%ignore UnregisterForClientMessageEvent;

%soarbox_shared(sml::ClientErrors)
%soarbox_shared(sml::Kernel)
%soarbox_shared(sml::Agent)
%soarbox_shared(sml::WMElement)
%soarbox_shared(sml::StringElement)
%soarbox_shared(sml::IntElement)
%soarbox_shared(sml::FloatElement)
%soarbox_shared(sml::Identifier)
%soarbox_shared(sml::IdentifierSymbol)
%soarbox_after_shared
%newobject sml::Kernel::GetConnectionInfo;

// An agent that runs in another thread locks its kernel: stopping must not wait for the lock.
%ignore sml::Agent::StopSelf;
%extend sml::Agent {
  %rename(StopSelf) SoarboxStop;
  std::string SoarboxStop() {
    const soarbox::bindings::Life* life = soarbox::bindings::Call::Near();
    if (!life || !life->entry->StopAgent($self, life->agent_life)) {
      throw soarbox::bindings::Gone("This agent has been destroyed.");
    }
    return "";
  }
}

// Unions contain internal data of the library.
#pragma SWIG nowarn=312
%include "sml_Names.h"
%include "ElementXML.h"
%include "sml_Events.h"
%include "sml_ClientErrors.h"
%include "sml_ClientWMElement.h"
%include "sml_ClientStringElement.h"
%include "sml_ClientIntElement.h"
%include "sml_ClientFloatElement.h"
%include "sml_ClientIdentifier.h"
%include "sml_ClientKernel.h"
%include "sml_ClientAgent.h"
%include "sml_ClientXML.h"
%include "sml_ClientTraceXML.h"
%include "sml_ClientAnalyzedXML.h"
