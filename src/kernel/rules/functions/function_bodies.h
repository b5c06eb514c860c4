// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "kernel/rules/functions/function_context.h"

/// The bodies of the built-in functions, by topic; see BuiltinFunction::evaluate for their contract.
namespace soarbox::kernel::function_bodies {

Symbol Write(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Crlf(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Halt(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Interrupt(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Wait(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Count(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Log(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Trace(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Exec(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Cmd(FunctionContext& context, std::span<const Symbol> arguments);
Symbol DecisionCycle(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Timestamp(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Accept(FunctionContext& context, std::span<const Symbol> arguments);
Symbol DontLearn(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ForceLearn(FunctionContext& context, std::span<const Symbol> arguments);
Symbol LinkToLongTerm(FunctionContext& context, std::span<const Symbol> arguments);
Symbol LongTermNumber(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Concat(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ToText(FunctionContext& context, std::span<const Symbol> arguments);
Symbol MakeConstant(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Capitalize(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Trim(FunctionContext& context, std::span<const Symbol> arguments);
Symbol TextLength(FunctionContext& context, std::span<const Symbol> arguments);
Symbol IfEqual(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Plus(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Times(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Minus(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Divide(FunctionContext& context, std::span<const Symbol> arguments);
Symbol IntegerDivide(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Modulo(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Minimum(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Maximum(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Absolute(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SquareRoot(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Sine(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Cosine(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ArcTangent(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ToInteger(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ToFloat(FunctionContext& context, std::span<const Symbol> arguments);
Symbol RandomInteger(FunctionContext& context, std::span<const Symbol> arguments);
Symbol RandomFloat(FunctionContext& context, std::span<const Symbol> arguments);
Symbol RoundOff(FunctionContext& context, std::span<const Symbol> arguments);
Symbol RoundOffHeading(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Heading(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Range(FunctionContext& context, std::span<const Symbol> arguments);
Symbol PredictX(FunctionContext& context, std::span<const Symbol> arguments);
Symbol PredictY(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ClosestIntercept(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ClosestToVector(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Haversine(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ExtrapolateX(FunctionContext& context, std::span<const Symbol> arguments);
Symbol ExtrapolateY(FunctionContext& context, std::span<const Symbol> arguments);
Symbol DiceProbability(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Size(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Sum(FunctionContext& context, std::span<const Symbol> arguments);
Symbol Product(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetCount(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetSum(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetMultiply(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetMinimum(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetMaximum(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetRange(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetMean(FunctionContext& context, std::span<const Symbol> arguments);
Symbol SetDeviation(FunctionContext& context, std::span<const Symbol> arguments);
Symbol DeepCopy(FunctionContext& context, std::span<const Symbol> arguments);
Symbol FromXml(FunctionContext& context, std::span<const Symbol> arguments);

}  // namespace soarbox::kernel::function_bodies
