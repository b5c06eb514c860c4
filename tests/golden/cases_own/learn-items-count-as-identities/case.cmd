# each item of an impasse counts as a firing with two identities of its own, and again when the items change; numeric operators are no non-numeric items
chunk always
sp {pier*init (state <s> ^superstate nil) --> (<s> ^berth 1 ^berth 2 ^berth 3 ^size 9)}
sp {pier*propose (state <s> ^superstate nil ^berth <b>) --> (<s> ^operator <o> +) (<o> ^name dock ^berth <b>)}
run 2
chunk stats
sp {pier*number (state <s> ^superstate nil ^operator <o> +) (<o> ^berth 1) --> (<s> ^operator <o> = 3)}
run 1
chunk stats
