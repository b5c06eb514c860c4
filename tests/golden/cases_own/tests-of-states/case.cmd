source agent.soar
print --internal several
print --internal several*negated
print --internal several*plain
print several
print several*negated
print --internal linked
print --internal linked*inside
print --internal conjunction
print conjunction
print --internal path
print --internal tested
print --internal both
print --internal attribute
