epmem --enable
sp {sub (state <s> ^superstate <ss>) (<ss> ^superstate nil) --> (<s> ^inner yes)}
trace 0
run 3
print e1
print e2
print e3
print e4
epmem --disable
run 1
print -i e5
