source agent.soar
decide set-random-seed 5
soar
smem --enable
epmem --enable
wma --set activation on
chunk always
soar
chunk never
matches
matches --timetags
run 1
preferences s1 smem
preferences s1 epmem
preferences s1 reward-link
preferences s1 io
print (@4 ^x *)
print (s1 ^x @3)
print --varprint t1
print t1
pbreak --print go*left
production firing-counts --all go*left
production firing-counts --user nosuch
production memory-usage --user go*left
wma --set decay-rate 3
wma --set decay-rate -0.3
wma --set foo 1
epmem --print x
epmem --print 0
gp {turn (state <s> ^went [left right]) --> (<s> ^turned [yes no])}
fc
fc turn*1
