# wm remove of what rules made leaves the preferences; the selected operator is applied although its proposal has gone; words that wm add refuses
decide indifferent-selection -f
sp {a (state <s> ^superstate nil) --> (<s> ^x <x>) (<x> ^p 1 ^q 2)}
sp {b (state <s> ^x.p 1) --> (<s> ^has-p yes)}
sp {o (state <s> ^superstate nil -^n) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {oa (state <s> ^operator.name go) --> (<s> ^n 1)}
run 1
print -i s1
print -i x1
watch 5
wm remove 18
wm remove 17
run 1
print x1
print s1
preferences x1 p
preferences s1 x
wm remove 14
wm remove 16
run 1
print s1
wm add s1 foo.x 2
wm add s1 ^foo.y 2
wm add s1 ^a.b.c 2
wm add s1 ^|foo.z| 2
wm add s1 ^<x> 2
wm add s1 ^{a} 2
wm add s1 ^a (b)
wm add s1 ^a <x>
wm add s1 ^@1 3
wm add s1 ^-x 3
wm add s1 3 3
wm add s1 ^3.5 3
wm add s1 ^s1 3
wm add s1 ^x1 4
