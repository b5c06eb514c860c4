// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <jni.h>

#include <functional>

#include "call.h"

/// Registers Java objects (class sml.Handler) as handlers of the library, and calls the library from Java.
namespace soarbox::java {

/// Calls the library. Calls that belong to no kernel are serialized, because threads may share a piece of XML.
void CallLibrary(bindings::Call::Hold hold, const std::function<void()>& call);

/// Returns the lock to hold while a call that belongs to a kernel changes a piece of XML.
std::unique_lock<std::recursive_mutex> HoldValues();

/// Stores the virtual machine and Java's class Handler. Returns false and sets an exception in Java if there is no such
/// class.
bool Begin(JavaVM* machine);
/// Stops all runs and shuts all kernels down. May wait for handlers.
using bindings::EndKernels;
/// Prevents all further calls of Java handlers, because the virtual machine is about to end.
void ShutDoor();

/// Register an object of the class Handler. They return the id; 0 if the library refuses. They throw
/// std::invalid_argument if the event is none of this kind.
int OnRun(sml::Agent& agent, int event, jobject handler);
int OnProduction(sml::Agent& agent, int event, jobject handler);
int OnPrint(sml::Agent& agent, int event, jobject handler, bool ignore_own_echos);
int OnXml(sml::Agent& agent, int event, jobject handler);
int OnOutput(sml::Agent& agent, const char* attribute, jobject handler);
int OnOutputNotification(sml::Agent& agent, jobject handler);
int OnSystem(sml::Kernel& kernel, int event, jobject handler);
int OnUpdate(sml::Kernel& kernel, int event, jobject handler);
int OnString(sml::Kernel& kernel, int event, jobject handler);
int OnAgent(sml::Kernel& kernel, int event, jobject handler);
int AddRhsFunction(sml::Kernel& kernel, const char* name, jobject handler);
int OnClientMessage(sml::Kernel& kernel, const char* client, jobject handler);

/// Drops the handler with this id, after the library has removed it.
using bindings::Forget;

}  // namespace soarbox::java
