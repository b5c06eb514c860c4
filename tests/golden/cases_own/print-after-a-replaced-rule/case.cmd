# Soar's printer counts the "#" that tells of a replaced rule: the next object is wrapped by what is left of the line.
sp {old (state <s> ^nothing x) --> (<s> ^y z)}
sp {init*0 (state <s> ^superstate nil) --> (<s> ^q0 <a>) (<a> ^a 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*1 (state <s> ^superstate nil) --> (<s> ^q1 <a>) (<a> ^aa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*2 (state <s> ^superstate nil) --> (<s> ^q2 <a>) (<a> ^aaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*3 (state <s> ^superstate nil) --> (<s> ^q3 <a>) (<a> ^aaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*4 (state <s> ^superstate nil) --> (<s> ^q4 <a>) (<a> ^aaaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*5 (state <s> ^superstate nil) --> (<s> ^q5 <a>) (<a> ^aaaaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*6 (state <s> ^superstate nil) --> (<s> ^q6 <a>) (<a> ^aaaaaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*7 (state <s> ^superstate nil) --> (<s> ^q7 <a>) (<a> ^aaaaaaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*8 (state <s> ^superstate nil) --> (<s> ^q8 <a>) (<a> ^aaaaaaaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*9 (state <s> ^superstate nil) --> (<s> ^q9 <a>) (<a> ^aaaaaaaaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
sp {init*10 (state <s> ^superstate nil) --> (<s> ^q10 <a>) (<a> ^aaaaaaaaaaa 1 ^b bbbbbbb ^c ccccccc ^d ddddddd ^e eeeeeee ^f fffffff ^g ggggggg)}
run 1
print s1
print a1
sp {old (state <s> ^nothing x) --> (<s> ^y z1)}
print a1
print a2
sp {old (state <s> ^nothing x) --> (<s> ^y z2)}
print a2
print a3
sp {old (state <s> ^nothing x) --> (<s> ^y z3)}
print a3
print a4
sp {old (state <s> ^nothing x) --> (<s> ^y z4)}
print a4
print a5
sp {old (state <s> ^nothing x) --> (<s> ^y z5)}
print a5
print a6
sp {old (state <s> ^nothing x) --> (<s> ^y z6)}
print a6
print a7
sp {old (state <s> ^nothing x) --> (<s> ^y z7)}
print a7
print a8
sp {old (state <s> ^nothing x) --> (<s> ^y z8)}
print a8
print a9
sp {old (state <s> ^nothing x) --> (<s> ^y z9)}
print a9
print a10
sp {old (state <s> ^nothing x) --> (<s> ^y z10)}
print a10
print a11
sp {old (state <s> ^nothing x) --> (<s> ^y z11)}
print a11
sp {old (state <s> ^nothing x) --> (<s> ^y again)}
sp {old (state <s> ^nothing x) --> (<s> ^y more)}
print a1
sp {old (state <s> ^nothing x) --> (<s> ^y last)}
watch 1
run 1
