# a copy of a state leaves out what the architecture says of its impasse
sp {a (state <s> ^superstate nil) --> (<s> ^x <x>) (<x> ^p 1)}
sp {b (state <s> ^superstate <ss>) (<ss> ^x <x>) --> (<s> ^d (deep-copy <s>))}
run 2
print -d 3 s2
