rec( isBlockDesign := true, v := 4, blocks := [ [ 1, 2, 3 ], [ 1, 2, 4 ], [ 1, 3, 4 ] ] )
