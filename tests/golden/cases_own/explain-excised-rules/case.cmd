source agent.soar
trace 0
chunk always
explain all on
run 3
explain chunk 1
explain instantiation 5
explain wm-trace
explain instantiation 5
explain instantiation 4
explain explanation-trace
excise --chunks
explain chunk 1
explain wm-trace
explain explanation-trace
explain formation
explain instantiation 5
explain instantiation 3
excise lamp*note
explain instantiation 3
explain formation
excise lamp*measure
explain instantiation 3
explain instantiation 4
explain formation
explain wm-trace
explain formation
explain instantiation 3
explain stats
explain identity
