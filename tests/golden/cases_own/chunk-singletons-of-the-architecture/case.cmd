# Singletons of the architecture, and what setting and removing them says.
chunk singleton state operator operator
chunk singleton state type constant
chunk singleton state attribute any
chunk singleton any impasse constant
chunk singleton state impasse any
chunk singleton state superstate any
chunk singleton state superstate state
chunk singleton -r state superstate any
chunk singleton -r any superstate any
chunk singleton -r any operator any
chunk singleton state smem identifier
chunk singleton identifier smem any
chunk singleton any smem any
