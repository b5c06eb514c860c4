# A value in bars ends with its second bar, whatever follows; what stands before the first bar belongs to it.
gp {g1 (state <s> ^x [ |a b||c d| ]) --> (<s> ^y 1)}
gp {g2 (state <s> ^x [ a|b c|d ]) --> (<s> ^y 1)}
gp {g3 (state <s> ^x [ |a b|c d|e| ]) --> (<s> ^y 1)}
gp {g5 (state <s> ^x [ |a\|b||c| |\|d| ]) --> (<s> ^y 1)}
gp {g6 (state <s> ^[a|b| c] 1) --> (<s> ^y 1)}
print --full g1*1
print --full g1*2
print --full g2*1
print --full g2*2
print --full g2*3
print --full g3*1
print --full g3*2
print --full g3*3
print --full g3*4
print --full g5*1
print --full g5*2
print --full g5*3
print --full g6*1
print --full g6*2
print --full g6*3
