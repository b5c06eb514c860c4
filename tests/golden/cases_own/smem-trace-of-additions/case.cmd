source agent.soar
trace --smem
smem --add {(@1 ^a b c 3 4.5 |x y| ^l @2 @3) (@2 ^n 1.0) (<v> ^k @9)}
smem --add {(@1 ^a b d)}
smem --add {(@1 ^path.to 5)}
smem --remove {(@1 ^a b)}
smem --remove {(@1 ^l)}
smem --remove {(@2)}
run 1
trace --smem remove
smem --add {(@1 ^a e)}
