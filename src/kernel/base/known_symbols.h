// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "kernel/base/symbol.h"

/// The symbols that every table contains from the start, with fixed handles: the words of the architecture and the
/// names of the built-in functions. Their order is their order of creation, which decides ties when conditions are
/// reordered. The integers 0 to 100 are created between the two groups (kPredefinedBeforeIntegers).
namespace soarbox::kernel {

namespace words {
inline constexpr Symbol kAt{Symbol::Tag::kString, 0};
inline constexpr Symbol kProblemSpace{Symbol::Tag::kString, 1};
inline constexpr Symbol kState{Symbol::Tag::kString, 2};
inline constexpr Symbol kOperator{Symbol::Tag::kString, 3};
inline constexpr Symbol kSuperstate{Symbol::Tag::kString, 4};
inline constexpr Symbol kIo{Symbol::Tag::kString, 5};
inline constexpr Symbol kObject{Symbol::Tag::kString, 6};
inline constexpr Symbol kAttribute{Symbol::Tag::kString, 7};
inline constexpr Symbol kImpasse{Symbol::Tag::kString, 8};
inline constexpr Symbol kChoices{Symbol::Tag::kString, 9};
inline constexpr Symbol kNone{Symbol::Tag::kString, 10};
inline constexpr Symbol kConstraintFailure{Symbol::Tag::kString, 11};
inline constexpr Symbol kNoChange{Symbol::Tag::kString, 12};
inline constexpr Symbol kMultiple{Symbol::Tag::kString, 13};
inline constexpr Symbol kItemCount{Symbol::Tag::kString, 14};
inline constexpr Symbol kNonNumericCount{Symbol::Tag::kString, 15};
inline constexpr Symbol kConstant{Symbol::Tag::kString, 16};
inline constexpr Symbol kConflict{Symbol::Tag::kString, 17};
inline constexpr Symbol kTie{Symbol::Tag::kString, 18};
inline constexpr Symbol kItem{Symbol::Tag::kString, 19};
inline constexpr Symbol kNonNumeric{Symbol::Tag::kString, 20};
inline constexpr Symbol kQuiescence{Symbol::Tag::kString, 21};
inline constexpr Symbol kT{Symbol::Tag::kString, 22};
inline constexpr Symbol kNil{Symbol::Tag::kString, 23};
inline constexpr Symbol kType{Symbol::Tag::kString, 24};
inline constexpr Symbol kGoal{Symbol::Tag::kString, 25};
inline constexpr Symbol kName{Symbol::Tag::kString, 26};
inline constexpr Symbol kMemorySystemRecall{Symbol::Tag::kString, 27};
inline constexpr Symbol kArchitectureText{Symbol::Tag::kString, 28};
inline constexpr Symbol kShortTermIdentifier{Symbol::Tag::kString, 29};
inline constexpr Symbol kInputLink{Symbol::Tag::kString, 30};
inline constexpr Symbol kOutputLink{Symbol::Tag::kString, 31};
inline constexpr Symbol kRewardLink{Symbol::Tag::kString, 32};
inline constexpr Symbol kReward{Symbol::Tag::kString, 33};
inline constexpr Symbol kValue{Symbol::Tag::kString, 34};
inline constexpr Symbol kEpmem{Symbol::Tag::kString, 35};
inline constexpr Symbol kCommand{Symbol::Tag::kString, 36};
inline constexpr Symbol kResult{Symbol::Tag::kString, 37};
inline constexpr Symbol kRetrieved{Symbol::Tag::kString, 38};
inline constexpr Symbol kStatus{Symbol::Tag::kString, 39};
inline constexpr Symbol kMatchScore{Symbol::Tag::kString, 40};
inline constexpr Symbol kCueSize{Symbol::Tag::kString, 41};
inline constexpr Symbol kNormalizedMatchScore{Symbol::Tag::kString, 42};
inline constexpr Symbol kMatchCardinality{Symbol::Tag::kString, 43};
inline constexpr Symbol kMemoryId{Symbol::Tag::kString, 44};
inline constexpr Symbol kPresentId{Symbol::Tag::kString, 45};
inline constexpr Symbol kNoMemory{Symbol::Tag::kString, 46};
inline constexpr Symbol kGraphMatch{Symbol::Tag::kString, 47};
inline constexpr Symbol kMapping{Symbol::Tag::kString, 48};
inline constexpr Symbol kNode{Symbol::Tag::kString, 49};
inline constexpr Symbol kCue{Symbol::Tag::kString, 50};
inline constexpr Symbol kSuccess{Symbol::Tag::kString, 51};
inline constexpr Symbol kFailure{Symbol::Tag::kString, 52};
inline constexpr Symbol kBadCmd{Symbol::Tag::kString, 53};
inline constexpr Symbol kRetrieve{Symbol::Tag::kString, 54};
inline constexpr Symbol kNext{Symbol::Tag::kString, 55};
inline constexpr Symbol kPrevious{Symbol::Tag::kString, 56};
inline constexpr Symbol kQuery{Symbol::Tag::kString, 57};
inline constexpr Symbol kNegQuery{Symbol::Tag::kString, 58};
inline constexpr Symbol kBefore{Symbol::Tag::kString, 59};
inline constexpr Symbol kAfter{Symbol::Tag::kString, 60};
inline constexpr Symbol kProhibit{Symbol::Tag::kString, 61};
inline constexpr Symbol kYes{Symbol::Tag::kString, 62};
inline constexpr Symbol kNo{Symbol::Tag::kString, 63};
inline constexpr Symbol kSmem{Symbol::Tag::kString, 64};
inline constexpr Symbol kDepthRetrieved{Symbol::Tag::kString, 65};
inline constexpr Symbol kActivation{Symbol::Tag::kString, 66};
inline constexpr Symbol kDepth{Symbol::Tag::kString, 67};
inline constexpr Symbol kStoreNew{Symbol::Tag::kString, 68};
inline constexpr Symbol kLinkToNewLtm{Symbol::Tag::kString, 69};
inline constexpr Symbol kLinkToLtm{Symbol::Tag::kString, 70};
inline constexpr Symbol kStore{Symbol::Tag::kString, 71};
inline constexpr Symbol kMathQuery{Symbol::Tag::kString, 72};
inline constexpr Symbol kLess{Symbol::Tag::kString, 73};
inline constexpr Symbol kGreater{Symbol::Tag::kString, 74};
inline constexpr Symbol kLessOrEqual{Symbol::Tag::kString, 75};
inline constexpr Symbol kGreaterOrEqual{Symbol::Tag::kString, 76};
inline constexpr Symbol kMax{Symbol::Tag::kString, 77};
inline constexpr Symbol kMin{Symbol::Tag::kString, 78};
inline constexpr Symbol kCount{Symbol::Tag::kString, 79};
inline constexpr Symbol kDontLearn{Symbol::Tag::kString, 80};
inline constexpr Symbol kForceLearn{Symbol::Tag::kString, 81};
inline constexpr Symbol kHalt{Symbol::Tag::kString, 82};
inline constexpr Symbol kLinkStmToLtm{Symbol::Tag::kString, 83};
inline constexpr Symbol kWait{Symbol::Tag::kString, 84};
inline constexpr Symbol kWrite{Symbol::Tag::kString, 85};
inline constexpr Symbol kTrace{Symbol::Tag::kString, 86};
inline constexpr Symbol kLog{Symbol::Tag::kString, 87};
inline constexpr Symbol kCapitalizeSymbol{Symbol::Tag::kString, 88};
inline constexpr Symbol kCrlf{Symbol::Tag::kString, 89};
inline constexpr Symbol kDc{Symbol::Tag::kString, 90};
inline constexpr Symbol kMakeConstantSymbol{Symbol::Tag::kString, 91};
inline constexpr Symbol kStrlen{Symbol::Tag::kString, 92};
inline constexpr Symbol kTimestamp{Symbol::Tag::kString, 93};
inline constexpr Symbol kTrim{Symbol::Tag::kString, 94};
inline constexpr Symbol kString{Symbol::Tag::kString, 95};
inline constexpr Symbol kAccept{Symbol::Tag::kString, 96};
inline constexpr Symbol kDeepCopy{Symbol::Tag::kString, 97};
inline constexpr Symbol kIfeq{Symbol::Tag::kString, 98};
inline constexpr Symbol kFromStXml{Symbol::Tag::kString, 99};
inline constexpr Symbol kPlus{Symbol::Tag::kString, 100};
inline constexpr Symbol kTimes{Symbol::Tag::kString, 101};
inline constexpr Symbol kMinus{Symbol::Tag::kString, 102};
inline constexpr Symbol kDivide{Symbol::Tag::kString, 103};
inline constexpr Symbol kDiv{Symbol::Tag::kString, 104};
inline constexpr Symbol kSize{Symbol::Tag::kString, 105};
inline constexpr Symbol kSum{Symbol::Tag::kString, 106};
inline constexpr Symbol kProduct{Symbol::Tag::kString, 107};
inline constexpr Symbol kMod{Symbol::Tag::kString, 108};
inline constexpr Symbol kSetCount{Symbol::Tag::kString, 109};
inline constexpr Symbol kSetSum{Symbol::Tag::kString, 110};
inline constexpr Symbol kSetMultiply{Symbol::Tag::kString, 111};
inline constexpr Symbol kSetMin{Symbol::Tag::kString, 112};
inline constexpr Symbol kSetMax{Symbol::Tag::kString, 113};
inline constexpr Symbol kSetRange{Symbol::Tag::kString, 114};
inline constexpr Symbol kSetMean{Symbol::Tag::kString, 115};
inline constexpr Symbol kSetStdev{Symbol::Tag::kString, 116};
inline constexpr Symbol kSin{Symbol::Tag::kString, 117};
inline constexpr Symbol kCos{Symbol::Tag::kString, 118};
inline constexpr Symbol kAtan2{Symbol::Tag::kString, 119};
inline constexpr Symbol kSqrt{Symbol::Tag::kString, 120};
inline constexpr Symbol kAbs{Symbol::Tag::kString, 121};
inline constexpr Symbol kInt{Symbol::Tag::kString, 122};
inline constexpr Symbol kFloat{Symbol::Tag::kString, 123};
inline constexpr Symbol kRoundOffHeading{Symbol::Tag::kString, 124};
inline constexpr Symbol kRoundOff{Symbol::Tag::kString, 125};
inline constexpr Symbol kComputeHeading{Symbol::Tag::kString, 126};
inline constexpr Symbol kComputeRange{Symbol::Tag::kString, 127};
inline constexpr Symbol kPredictX{Symbol::Tag::kString, 128};
inline constexpr Symbol kPredictY{Symbol::Tag::kString, 129};
inline constexpr Symbol kComputeClosestIntercept{Symbol::Tag::kString, 130};
inline constexpr Symbol kComputeDiceProbability{Symbol::Tag::kString, 131};
inline constexpr Symbol kRandInt{Symbol::Tag::kString, 132};
inline constexpr Symbol kRandFloat{Symbol::Tag::kString, 133};
inline constexpr Symbol kEvaluateObject{Symbol::Tag::kString, 134};
inline constexpr Symbol kSvs{Symbol::Tag::kString, 135};
inline constexpr Symbol kSpatialScene{Symbol::Tag::kString, 136};
inline constexpr Symbol kChild{Symbol::Tag::kString, 137};
inline constexpr Symbol kId{Symbol::Tag::kString, 138};
inline constexpr Symbol kInterrupt{Symbol::Tag::kString, 139};
inline constexpr Symbol kConcat{Symbol::Tag::kString, 140};
inline constexpr Symbol kExec{Symbol::Tag::kString, 141};
inline constexpr Symbol kCmd{Symbol::Tag::kString, 142};
}  // namespace words

inline constexpr std::array<std::string_view, 143> kPredefinedWords = {
    "@",
    "problem-space",
    "state",
    "operator",
    "superstate",
    "io",
    "object",
    "attribute",
    "impasse",
    "choices",
    "none",
    "constraint-failure",
    "no-change",
    "multiple",
    "item-count",
    "non-numeric-count",
    "constant",
    "conflict",
    "tie",
    "item",
    "non-numeric",
    "quiescence",
    "t",
    "nil",
    "type",
    "goal",
    "name",
    "Memory System Recall",
    "Architecture",
    "[STI]",
    "input-link",
    "output-link",
    "reward-link",
    "reward",
    "value",
    "epmem",
    "command",
    "result",
    "retrieved",
    "status",
    "match-score",
    "cue-size",
    "normalized-match-score",
    "match-cardinality",
    "memory-id",
    "present-id",
    "no-memory",
    "graph-match",
    "mapping",
    "node",
    "cue",
    "success",
    "failure",
    "bad-cmd",
    "retrieve",
    "next",
    "previous",
    "query",
    "neg-query",
    "before",
    "after",
    "prohibit",
    "yes",
    "no",
    "smem",
    "depth-retrieved",
    "activation",
    "depth",
    "store-new",
    "link-to-new-ltm",
    "link-to-ltm",
    "store",
    "math-query",
    "less",
    "greater",
    "less-or-equal",
    "greater-or-equal",
    "max",
    "min",
    "count",
    "dont-learn",
    "force-learn",
    "halt",
    "link-stm-to-ltm",
    "wait",
    "write",
    "trace",
    "log",
    "capitalize-symbol",
    "crlf",
    "dc",
    "make-constant-symbol",
    "strlen",
    "timestamp",
    "trim",
    "string",
    "accept",
    "deep-copy",
    "ifeq",
    "from-st-xml",
    "+",
    "*",
    "-",
    "/",
    "div",
    "size",
    "sum",
    "product",
    "mod",
    "set-count",
    "set-sum",
    "set-multiply",
    "set-min",
    "set-max",
    "set-range",
    "set-mean",
    "set-stdev",
    "sin",
    "cos",
    "atan2",
    "sqrt",
    "abs",
    "int",
    "float",
    "round-off-heading",
    "round-off",
    "compute-heading",
    "compute-range",
    "predict-x",
    "predict-y",
    "compute-closest-intercept",
    "compute-dice-probability",
    "rand-int",
    "rand-float",
    "evaluate-object",
    "svs",
    "spatial-scene",
    "child",
    "id",
    "interrupt",
    "concat",
    "exec",
    "cmd",
};

/// Number of kPredefinedWords that are created before the integers 0 to 100.
inline constexpr std::uint32_t kPredefinedBeforeIntegers = 79;

}  // namespace soarbox::kernel
