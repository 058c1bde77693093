% SPDX-License-Identifier: BSD-3-Clause
% The office building, written by tools/make_building.py. Metres; origin at the lower left of every
% floor, x to the east, y to the north.
%   floor(Number, Image, MetresPerPixel)          room(Room, Floor, X1, Y1, X2, Y2)
%   landmark(Name, Floor, X, Y)                   floor 0: in a cab, wherever the cab is
%   adjacent(Landmark, Landmark)                  undirected; the straight line is free
%   door(Door, Floor, X1, Y1, X2, Y2)             the shut leaf; also the landmark in its middle
%   elevator(E, X1, Y1, X2, Y2, Dx1, Dy1, Dx2, Dy2)   cab rectangle and door leaf, on every floor
%   cab(E, Landmark)  lobby(E, Landmark, Floor)   the places inside and in front of an elevator
% Landmarks: r room, i inside a door, d in a door, c in the corridor before a door, x crossing, l lobby.
cnf(b1, axiom, floor(1, 'floor1.png', 0.05)).
cnf(b2, axiom, room(r1_01, 1, 0.2, 0.2, 4.6, 6.65)).
cnf(b3, axiom, room(r1_02, 1, 4.75, 0.2, 9.5, 6.65)).
cnf(b4, axiom, room(r1_03, 1, 9.65, 0.2, 16.5, 6.65)).
cnf(b5, axiom, room(r1_04, 1, 16.65, 0.2, 21.5, 6.65)).
cnf(b6, axiom, room(r1_05, 1, 21.65, 0.2, 29.0, 6.65)).
cnf(b7, axiom, room(r1_06, 1, 29.15, 0.2, 36.0, 6.65)).
cnf(b8, axiom, room(r1_07, 1, 36.15, 0.2, 43.8, 6.65)).
cnf(b9, axiom, room(r1_08, 1, 0.2, 9.15, 6.35, 13.95)).
cnf(b10, axiom, room(r1_09, 1, 8.85, 9.15, 12.7, 13.95)).
cnf(b11, axiom, room(r1_10, 1, 12.85, 9.15, 16.65, 13.95)).
cnf(b12, axiom, room(r1_11, 1, 24.15, 9.15, 29.2, 13.95)).
cnf(b13, axiom, room(r1_12, 1, 29.35, 9.15, 34.35, 13.95)).
cnf(b14, axiom, room(r1_13, 1, 36.85, 9.15, 43.8, 13.95)).
cnf(b15, axiom, room(r1_14, 1, 0.2, 14.1, 6.35, 18.85)).
cnf(b16, axiom, room(r1_15, 1, 8.85, 14.1, 16.65, 18.85)).
cnf(b17, axiom, room(r1_16, 1, 24.15, 14.1, 29.2, 18.85)).
cnf(b18, axiom, room(r1_17, 1, 29.35, 14.1, 34.35, 18.85)).
cnf(b19, axiom, room(r1_18, 1, 36.85, 14.1, 43.8, 18.85)).
cnf(b20, axiom, room(r1_19, 1, 0.2, 21.35, 7.5, 27.8)).
cnf(b21, axiom, room(r1_20, 1, 7.65, 21.35, 12.5, 27.8)).
cnf(b22, axiom, room(r1_21, 1, 12.65, 21.35, 17.25, 27.8)).
cnf(b23, axiom, room(r1_22, 1, 17.4, 21.35, 25.25, 27.8)).
cnf(b24, axiom, room(r1_23, 1, 25.4, 21.35, 30.3, 27.8)).
cnf(b25, axiom, room(r1_24, 1, 30.45, 21.35, 36.0, 27.8)).
cnf(b26, axiom, room(r1_25, 1, 36.15, 21.35, 43.8, 27.8)).
cnf(b27, axiom, landmark(c1_01, 1, 1.4, 7.9)).
cnf(b28, axiom, landmark(c1_04, 1, 20.3, 7.9)).
cnf(b29, axiom, landmark(c1_08, 1, 5.15, 7.9)).
cnf(b30, axiom, landmark(c1_09, 1, 10.05, 7.9)).
cnf(b31, axiom, landmark(c1_10, 1, 15.45, 7.9)).
cnf(b32, axiom, landmark(c1_11, 1, 25.35, 7.9)).
cnf(b33, axiom, landmark(c1_12, 1, 33.15, 7.9)).
cnf(b34, axiom, landmark(c1_12a, 1, 35.6, 11.55)).
cnf(b35, axiom, landmark(c1_13, 1, 38.05, 7.9)).
cnf(b36, axiom, landmark(c1_14, 1, 5.15, 20.1)).
cnf(b37, axiom, landmark(c1_15, 1, 10.05, 20.1)).
cnf(b38, axiom, landmark(c1_16, 1, 28.0, 20.1)).
cnf(b39, axiom, landmark(c1_17, 1, 30.55, 20.1)).
cnf(b40, axiom, landmark(c1_18, 1, 42.6, 20.1)).
cnf(b41, axiom, landmark(c1_21, 1, 13.85, 20.1)).
cnf(b42, axiom, landmark(c1_24, 1, 34.8, 20.1)).
cnf(b43, axiom, landmark(d1_01, 1, 1.4, 6.725)).
cnf(b44, axiom, landmark(d1_02, 1, 7.6, 6.725)).
cnf(b45, axiom, landmark(d1_02a, 1, 9.575, 3.4)).
cnf(b46, axiom, landmark(d1_03, 1, 15.45, 6.725)).
cnf(b47, axiom, landmark(d1_04, 1, 20.3, 6.725)).
cnf(b48, axiom, landmark(d1_05, 1, 25.35, 6.725)).
cnf(b49, axiom, landmark(d1_06, 1, 33.15, 6.725)).
cnf(b50, axiom, landmark(d1_07, 1, 38.05, 6.725)).
cnf(b51, axiom, landmark(d1_08, 1, 5.15, 9.075)).
cnf(b52, axiom, landmark(d1_09, 1, 10.05, 9.075)).
cnf(b53, axiom, landmark(d1_10, 1, 15.45, 9.075)).
cnf(b54, axiom, landmark(d1_11, 1, 25.35, 9.075)).
cnf(b55, axiom, landmark(d1_12, 1, 33.15, 9.075)).
cnf(b56, axiom, landmark(d1_12a, 1, 34.425, 11.55)).
cnf(b57, axiom, landmark(d1_13, 1, 38.05, 9.075)).
cnf(b58, axiom, landmark(d1_14, 1, 5.15, 18.925)).
cnf(b59, axiom, landmark(d1_15, 1, 10.05, 18.925)).
cnf(b60, axiom, landmark(d1_16, 1, 28.0, 18.925)).
cnf(b61, axiom, landmark(d1_17, 1, 30.55, 18.925)).
cnf(b62, axiom, landmark(d1_18, 1, 42.6, 18.925)).
cnf(b63, axiom, landmark(d1_19, 1, 5.15, 21.275)).
cnf(b64, axiom, landmark(d1_20, 1, 10.05, 21.275)).
cnf(b65, axiom, landmark(d1_21, 1, 13.85, 21.275)).
cnf(b66, axiom, landmark(d1_22, 1, 21.6, 21.275)).
cnf(b67, axiom, landmark(d1_23, 1, 28.0, 21.275)).
cnf(b68, axiom, landmark(d1_23a, 1, 30.375, 24.55)).
cnf(b69, axiom, landmark(d1_24, 1, 34.8, 21.275)).
cnf(b70, axiom, landmark(d1_25, 1, 42.6, 21.275)).
cnf(b71, axiom, landmark(i1_01, 1, 1.4, 5.75)).
cnf(b72, axiom, landmark(i1_02, 1, 7.6, 5.75)).
cnf(b73, axiom, landmark(i1_02a, 1, 8.6, 3.4)).
cnf(b74, axiom, landmark(i1_03, 1, 15.45, 5.75)).
cnf(b75, axiom, landmark(i1_03a, 1, 10.55, 3.4)).
cnf(b76, axiom, landmark(i1_04, 1, 20.3, 5.75)).
cnf(b77, axiom, landmark(i1_05, 1, 25.35, 5.75)).
cnf(b78, axiom, landmark(i1_06, 1, 33.15, 5.75)).
cnf(b79, axiom, landmark(i1_07, 1, 38.05, 5.75)).
cnf(b80, axiom, landmark(i1_08, 1, 5.15, 10.05)).
cnf(b81, axiom, landmark(i1_09, 1, 10.05, 10.05)).
cnf(b82, axiom, landmark(i1_10, 1, 15.45, 10.05)).
cnf(b83, axiom, landmark(i1_11, 1, 25.35, 10.05)).
cnf(b84, axiom, landmark(i1_12, 1, 33.15, 10.05)).
cnf(b85, axiom, landmark(i1_12a, 1, 33.45, 11.55)).
cnf(b86, axiom, landmark(i1_13, 1, 38.05, 10.05)).
cnf(b87, axiom, landmark(i1_14, 1, 5.15, 17.95)).
cnf(b88, axiom, landmark(i1_15, 1, 10.05, 17.95)).
cnf(b89, axiom, landmark(i1_16, 1, 28.0, 17.95)).
cnf(b90, axiom, landmark(i1_17, 1, 30.55, 17.95)).
cnf(b91, axiom, landmark(i1_18, 1, 42.6, 17.95)).
cnf(b92, axiom, landmark(i1_19, 1, 5.15, 22.25)).
cnf(b93, axiom, landmark(i1_20, 1, 10.05, 22.25)).
cnf(b94, axiom, landmark(i1_21, 1, 13.85, 22.25)).
cnf(b95, axiom, landmark(i1_22, 1, 21.6, 22.25)).
cnf(b96, axiom, landmark(i1_23, 1, 28.0, 22.25)).
cnf(b97, axiom, landmark(i1_23a, 1, 29.4, 24.55)).
cnf(b98, axiom, landmark(i1_24, 1, 34.8, 22.25)).
cnf(b99, axiom, landmark(i1_24a, 1, 31.35, 24.55)).
cnf(b100, axiom, landmark(i1_25, 1, 42.6, 22.25)).
cnf(b101, axiom, landmark(l1_e1, 1, 20.1, 12.5)).
cnf(b102, axiom, landmark(l1_e2, 1, 20.1, 15.5)).
cnf(b103, axiom, landmark(l1_mid, 1, 21.6, 14.0)).
cnf(b104, axiom, landmark(l1_n, 1, 21.6, 20.1)).
cnf(b105, axiom, landmark(l1_s, 1, 21.6, 7.9)).
cnf(b106, axiom, landmark(r1_01, 1, 2.4, 3.43)).
cnf(b107, axiom, landmark(r1_02, 1, 7.12, 3.43)).
cnf(b108, axiom, landmark(r1_03, 1, 12.76, 4.99)).
cnf(b109, axiom, landmark(r1_04, 1, 19.07, 3.43)).
cnf(b110, axiom, landmark(r1_05, 1, 25.33, 3.43)).
cnf(b111, axiom, landmark(r1_06, 1, 32.58, 3.43)).
cnf(b112, axiom, landmark(r1_07, 1, 40.28, 4.16)).
cnf(b113, axiom, landmark(r1_08, 1, 3.28, 11.55)).
cnf(b114, axiom, landmark(r1_09, 1, 10.78, 11.55)).
cnf(b115, axiom, landmark(r1_10, 1, 14.75, 11.55)).
cnf(b116, axiom, landmark(r1_11, 1, 26.68, 11.55)).
cnf(b117, axiom, landmark(r1_12, 1, 31.85, 11.55)).
cnf(b118, axiom, landmark(r1_13, 1, 40.33, 11.55)).
cnf(b119, axiom, landmark(r1_14, 1, 3.28, 16.48)).
cnf(b120, axiom, landmark(r1_15, 1, 13.06, 17.21)).
cnf(b121, axiom, landmark(r1_16, 1, 26.68, 16.48)).
cnf(b122, axiom, landmark(r1_17, 1, 31.85, 16.48)).
cnf(b123, axiom, landmark(r1_18, 1, 40.33, 16.48)).
cnf(b124, axiom, landmark(r1_19, 1, 3.54, 23.84)).
cnf(b125, axiom, landmark(r1_20, 1, 10.08, 24.58)).
cnf(b126, axiom, landmark(r1_21, 1, 14.95, 24.58)).
cnf(b127, axiom, landmark(r1_22, 1, 21.33, 24.58)).
cnf(b128, axiom, landmark(r1_23, 1, 27.85, 24.58)).
cnf(b129, axiom, landmark(r1_24, 1, 33.23, 24.58)).
cnf(b130, axiom, landmark(r1_25, 1, 39.98, 24.58)).
cnf(b131, axiom, landmark(x1_n1, 1, 7.6, 20.1)).
cnf(b132, axiom, landmark(x1_n2, 1, 35.6, 20.1)).
cnf(b133, axiom, landmark(x1_s1, 1, 7.6, 7.9)).
cnf(b134, axiom, landmark(x1_s2, 1, 35.6, 7.9)).
cnf(b135, axiom, door(d1_08, 1, 4.65, 9.075, 5.65, 9.075)).
cnf(b136, axiom, door(d1_09, 1, 9.55, 9.075, 10.55, 9.075)).
cnf(b137, axiom, door(d1_10, 1, 14.95, 9.075, 15.95, 9.075)).
cnf(b138, axiom, door(d1_11, 1, 24.85, 9.075, 25.85, 9.075)).
cnf(b139, axiom, door(d1_12, 1, 32.65, 9.075, 33.65, 9.075)).
cnf(b140, axiom, door(d1_13, 1, 37.55, 9.075, 38.55, 9.075)).
cnf(b141, axiom, door(d1_14, 1, 4.65, 18.925, 5.65, 18.925)).
cnf(b142, axiom, door(d1_15, 1, 9.55, 18.925, 10.55, 18.925)).
cnf(b143, axiom, door(d1_16, 1, 27.5, 18.925, 28.5, 18.925)).
cnf(b144, axiom, door(d1_17, 1, 30.05, 18.925, 31.05, 18.925)).
cnf(b145, axiom, door(d1_18, 1, 42.1, 18.925, 43.1, 18.925)).
cnf(b146, axiom, door(d1_01, 1, 0.9, 6.725, 1.9, 6.725)).
cnf(b147, axiom, door(d1_02, 1, 7.1, 6.725, 8.1, 6.725)).
cnf(b148, axiom, door(d1_03, 1, 14.95, 6.725, 15.95, 6.725)).
cnf(b149, axiom, door(d1_04, 1, 19.8, 6.725, 20.8, 6.725)).
cnf(b150, axiom, door(d1_05, 1, 24.85, 6.725, 25.85, 6.725)).
cnf(b151, axiom, door(d1_06, 1, 32.65, 6.725, 33.65, 6.725)).
cnf(b152, axiom, door(d1_07, 1, 37.55, 6.725, 38.55, 6.725)).
cnf(b153, axiom, door(d1_19, 1, 4.65, 21.275, 5.65, 21.275)).
cnf(b154, axiom, door(d1_20, 1, 9.55, 21.275, 10.55, 21.275)).
cnf(b155, axiom, door(d1_21, 1, 13.35, 21.275, 14.35, 21.275)).
cnf(b156, axiom, door(d1_22, 1, 21.1, 21.275, 22.1, 21.275)).
cnf(b157, axiom, door(d1_23, 1, 27.5, 21.275, 28.5, 21.275)).
cnf(b158, axiom, door(d1_24, 1, 34.3, 21.275, 35.3, 21.275)).
cnf(b159, axiom, door(d1_25, 1, 42.1, 21.275, 43.1, 21.275)).
cnf(b160, axiom, door(d1_02a, 1, 9.575, 2.9, 9.575, 3.9)).
cnf(b161, axiom, door(d1_12a, 1, 34.425, 11.05, 34.425, 12.05)).
cnf(b162, axiom, door(d1_23a, 1, 30.375, 24.05, 30.375, 25.05)).
cnf(b163, axiom, adjacent(c1_01, c1_08)).
cnf(b164, axiom, adjacent(c1_01, d1_01)).
cnf(b165, axiom, adjacent(c1_04, c1_10)).
cnf(b166, axiom, adjacent(c1_04, d1_04)).
cnf(b167, axiom, adjacent(c1_04, l1_s)).
cnf(b168, axiom, adjacent(c1_08, d1_08)).
cnf(b169, axiom, adjacent(c1_08, x1_s1)).
cnf(b170, axiom, adjacent(c1_09, c1_10)).
cnf(b171, axiom, adjacent(c1_09, d1_09)).
cnf(b172, axiom, adjacent(c1_09, x1_s1)).
cnf(b173, axiom, adjacent(c1_10, d1_03)).
cnf(b174, axiom, adjacent(c1_10, d1_10)).
cnf(b175, axiom, adjacent(c1_11, c1_12)).
cnf(b176, axiom, adjacent(c1_11, d1_05)).
cnf(b177, axiom, adjacent(c1_11, d1_11)).
cnf(b178, axiom, adjacent(c1_11, l1_s)).
cnf(b179, axiom, adjacent(c1_12, d1_06)).
cnf(b180, axiom, adjacent(c1_12, d1_12)).
cnf(b181, axiom, adjacent(c1_12, x1_s2)).
cnf(b182, axiom, adjacent(c1_12a, d1_12a)).
cnf(b183, axiom, adjacent(c1_12a, x1_n2)).
cnf(b184, axiom, adjacent(c1_12a, x1_s2)).
cnf(b185, axiom, adjacent(c1_13, d1_07)).
cnf(b186, axiom, adjacent(c1_13, d1_13)).
cnf(b187, axiom, adjacent(c1_13, x1_s2)).
cnf(b188, axiom, adjacent(c1_14, d1_14)).
cnf(b189, axiom, adjacent(c1_14, d1_19)).
cnf(b190, axiom, adjacent(c1_14, x1_n1)).
cnf(b191, axiom, adjacent(c1_15, c1_21)).
cnf(b192, axiom, adjacent(c1_15, d1_15)).
cnf(b193, axiom, adjacent(c1_15, d1_20)).
cnf(b194, axiom, adjacent(c1_15, x1_n1)).
cnf(b195, axiom, adjacent(c1_16, c1_17)).
cnf(b196, axiom, adjacent(c1_16, d1_16)).
cnf(b197, axiom, adjacent(c1_16, d1_23)).
cnf(b198, axiom, adjacent(c1_16, l1_n)).
cnf(b199, axiom, adjacent(c1_17, c1_24)).
cnf(b200, axiom, adjacent(c1_17, d1_17)).
cnf(b201, axiom, adjacent(c1_18, d1_18)).
cnf(b202, axiom, adjacent(c1_18, d1_25)).
cnf(b203, axiom, adjacent(c1_18, x1_n2)).
cnf(b204, axiom, adjacent(c1_21, d1_21)).
cnf(b205, axiom, adjacent(c1_21, l1_n)).
cnf(b206, axiom, adjacent(c1_24, d1_24)).
cnf(b207, axiom, adjacent(c1_24, x1_n2)).
cnf(b208, axiom, adjacent(d1_01, i1_01)).
cnf(b209, axiom, adjacent(d1_02, i1_02)).
cnf(b210, axiom, adjacent(d1_02, x1_s1)).
cnf(b211, axiom, adjacent(d1_02a, i1_02a)).
cnf(b212, axiom, adjacent(d1_02a, i1_03a)).
cnf(b213, axiom, adjacent(d1_03, i1_03)).
cnf(b214, axiom, adjacent(d1_04, i1_04)).
cnf(b215, axiom, adjacent(d1_05, i1_05)).
cnf(b216, axiom, adjacent(d1_06, i1_06)).
cnf(b217, axiom, adjacent(d1_07, i1_07)).
cnf(b218, axiom, adjacent(d1_08, i1_08)).
cnf(b219, axiom, adjacent(d1_09, i1_09)).
cnf(b220, axiom, adjacent(d1_10, i1_10)).
cnf(b221, axiom, adjacent(d1_11, i1_11)).
cnf(b222, axiom, adjacent(d1_12, i1_12)).
cnf(b223, axiom, adjacent(d1_12a, i1_12a)).
cnf(b224, axiom, adjacent(d1_13, i1_13)).
cnf(b225, axiom, adjacent(d1_14, i1_14)).
cnf(b226, axiom, adjacent(d1_15, i1_15)).
cnf(b227, axiom, adjacent(d1_16, i1_16)).
cnf(b228, axiom, adjacent(d1_17, i1_17)).
cnf(b229, axiom, adjacent(d1_18, i1_18)).
cnf(b230, axiom, adjacent(d1_19, i1_19)).
cnf(b231, axiom, adjacent(d1_20, i1_20)).
cnf(b232, axiom, adjacent(d1_21, i1_21)).
cnf(b233, axiom, adjacent(d1_22, i1_22)).
cnf(b234, axiom, adjacent(d1_22, l1_n)).
cnf(b235, axiom, adjacent(d1_23, i1_23)).
cnf(b236, axiom, adjacent(d1_23a, i1_23a)).
cnf(b237, axiom, adjacent(d1_23a, i1_24a)).
cnf(b238, axiom, adjacent(d1_24, i1_24)).
cnf(b239, axiom, adjacent(d1_25, i1_25)).
cnf(b240, axiom, adjacent(i1_01, r1_01)).
cnf(b241, axiom, adjacent(i1_02, r1_02)).
cnf(b242, axiom, adjacent(i1_02a, r1_02)).
cnf(b243, axiom, adjacent(i1_03, r1_03)).
cnf(b244, axiom, adjacent(i1_03a, r1_03)).
cnf(b245, axiom, adjacent(i1_04, r1_04)).
cnf(b246, axiom, adjacent(i1_05, r1_05)).
cnf(b247, axiom, adjacent(i1_06, r1_06)).
cnf(b248, axiom, adjacent(i1_07, r1_07)).
cnf(b249, axiom, adjacent(i1_08, r1_08)).
cnf(b250, axiom, adjacent(i1_09, r1_09)).
cnf(b251, axiom, adjacent(i1_10, r1_10)).
cnf(b252, axiom, adjacent(i1_11, r1_11)).
cnf(b253, axiom, adjacent(i1_12, r1_12)).
cnf(b254, axiom, adjacent(i1_12a, r1_12)).
cnf(b255, axiom, adjacent(i1_13, r1_13)).
cnf(b256, axiom, adjacent(i1_14, r1_14)).
cnf(b257, axiom, adjacent(i1_15, r1_15)).
cnf(b258, axiom, adjacent(i1_16, r1_16)).
cnf(b259, axiom, adjacent(i1_17, r1_17)).
cnf(b260, axiom, adjacent(i1_18, r1_18)).
cnf(b261, axiom, adjacent(i1_19, r1_19)).
cnf(b262, axiom, adjacent(i1_20, r1_20)).
cnf(b263, axiom, adjacent(i1_21, r1_21)).
cnf(b264, axiom, adjacent(i1_22, r1_22)).
cnf(b265, axiom, adjacent(i1_23, r1_23)).
cnf(b266, axiom, adjacent(i1_23a, r1_23)).
cnf(b267, axiom, adjacent(i1_24, r1_24)).
cnf(b268, axiom, adjacent(i1_24a, r1_24)).
cnf(b269, axiom, adjacent(i1_25, r1_25)).
cnf(b270, axiom, adjacent(l1_e1, l1_mid)).
cnf(b271, axiom, adjacent(l1_e2, l1_mid)).
cnf(b272, axiom, adjacent(l1_mid, l1_n)).
cnf(b273, axiom, adjacent(l1_mid, l1_s)).
cnf(b274, axiom, adjacent(x1_n1, x1_s1)).
cnf(b275, axiom, lobby(e1, l1_e1, 1)).
cnf(b276, axiom, lobby(e2, l1_e2, 1)).
cnf(b277, axiom, floor(2, 'floor2.png', 0.05)).
cnf(b278, axiom, room(r2_01, 2, 0.2, 0.2, 6.0, 6.25)).
cnf(b279, axiom, room(r2_02, 2, 6.15, 0.2, 10.8, 6.25)).
cnf(b280, axiom, room(r2_03, 2, 10.95, 0.2, 15.5, 6.25)).
cnf(b281, axiom, room(r2_04, 2, 15.65, 0.2, 20.2, 6.25)).
cnf(b282, axiom, room(r2_05, 2, 20.35, 0.2, 26.0, 6.25)).
cnf(b283, axiom, room(r2_06, 2, 26.15, 0.2, 31.0, 6.25)).
cnf(b284, axiom, room(r2_07, 2, 31.15, 0.2, 36.5, 6.25)).
cnf(b285, axiom, room(r2_08, 2, 36.65, 0.2, 43.8, 6.25)).
cnf(b286, axiom, room(r2_09, 2, 0.2, 8.75, 4.9, 13.6)).
cnf(b287, axiom, room(r2_10, 2, 5.05, 8.75, 10.15, 13.6)).
cnf(b288, axiom, room(r2_11, 2, 12.65, 8.75, 16.65, 13.6)).
cnf(b289, axiom, room(r2_12, 2, 24.15, 8.75, 30.85, 13.6)).
cnf(b290, axiom, room(r2_13, 2, 33.25, 8.75, 38.25, 13.6)).
cnf(b291, axiom, room(r2_14, 2, 38.4, 8.75, 43.8, 13.6)).
cnf(b292, axiom, room(r2_15, 2, 0.2, 13.75, 10.15, 19.15)).
cnf(b293, axiom, room(r2_16, 2, 12.65, 13.75, 16.65, 19.15)).
cnf(b294, axiom, room(r2_17, 2, 24.15, 13.75, 30.85, 19.15)).
cnf(b295, axiom, room(r2_18, 2, 33.25, 13.75, 43.8, 19.15)).
cnf(b296, axiom, room(r2_19, 2, 0.2, 21.75, 5.5, 27.8)).
cnf(b297, axiom, room(r2_20, 2, 5.65, 21.75, 12.5, 27.8)).
cnf(b298, axiom, room(r2_21, 2, 12.65, 21.75, 19.0, 27.8)).
cnf(b299, axiom, room(r2_22, 2, 19.15, 21.75, 37.0, 27.8)).
cnf(b300, axiom, room(r2_23, 2, 37.15, 21.75, 43.8, 27.8)).
cnf(b301, axiom, landmark(c2_04, 2, 19.0, 7.5)).
cnf(b302, axiom, landmark(c2_09, 2, 1.4, 7.5)).
cnf(b303, axiom, landmark(c2_10, 2, 8.95, 7.5)).
cnf(b304, axiom, landmark(c2_11, 2, 13.85, 7.5)).
cnf(b305, axiom, landmark(c2_12, 2, 29.65, 7.5)).
cnf(b306, axiom, landmark(c2_13, 2, 34.45, 7.5)).
cnf(b307, axiom, landmark(c2_14, 2, 42.6, 7.5)).
cnf(b308, axiom, landmark(c2_15, 2, 1.4, 20.45)).
cnf(b309, axiom, landmark(c2_16, 2, 15.45, 20.45)).
cnf(b310, axiom, landmark(c2_16a, 2, 11.4, 16.45)).
cnf(b311, axiom, landmark(c2_17, 2, 25.35, 20.45)).
cnf(b312, axiom, landmark(c2_18, 2, 42.6, 20.45)).
cnf(b313, axiom, landmark(c2_22, 2, 21.15, 20.45)).
cnf(b314, axiom, landmark(c2_22a, 2, 35.0, 20.45)).
cnf(b315, axiom, landmark(d2_01, 2, 1.4, 6.325)).
cnf(b316, axiom, landmark(d2_02, 2, 8.95, 6.325)).
cnf(b317, axiom, landmark(d2_03, 2, 13.85, 6.325)).
cnf(b318, axiom, landmark(d2_04, 2, 19.0, 6.325)).
cnf(b319, axiom, landmark(d2_05, 2, 21.6, 6.325)).
cnf(b320, axiom, landmark(d2_06, 2, 29.65, 6.325)).
cnf(b321, axiom, landmark(d2_07, 2, 32.05, 6.325)).
cnf(b322, axiom, landmark(d2_08, 2, 42.6, 6.325)).
cnf(b323, axiom, landmark(d2_09, 2, 1.4, 8.675)).
cnf(b324, axiom, landmark(d2_09a, 2, 4.975, 11.15)).
cnf(b325, axiom, landmark(d2_10, 2, 8.95, 8.675)).
cnf(b326, axiom, landmark(d2_11, 2, 13.85, 8.675)).
cnf(b327, axiom, landmark(d2_12, 2, 29.65, 8.675)).
cnf(b328, axiom, landmark(d2_13, 2, 34.45, 8.675)).
cnf(b329, axiom, landmark(d2_14, 2, 42.6, 8.675)).
cnf(b330, axiom, landmark(d2_15, 2, 1.4, 19.225)).
cnf(b331, axiom, landmark(d2_16, 2, 15.45, 19.225)).
cnf(b332, axiom, landmark(d2_16a, 2, 12.575, 16.45)).
cnf(b333, axiom, landmark(d2_17, 2, 25.35, 19.225)).
cnf(b334, axiom, landmark(d2_18, 2, 42.6, 19.225)).
cnf(b335, axiom, landmark(d2_19, 2, 1.4, 21.675)).
cnf(b336, axiom, landmark(d2_20, 2, 11.4, 21.675)).
cnf(b337, axiom, landmark(d2_21, 2, 15.45, 21.675)).
cnf(b338, axiom, landmark(d2_21a, 2, 19.075, 24.75)).
cnf(b339, axiom, landmark(d2_22, 2, 21.15, 21.675)).
cnf(b340, axiom, landmark(d2_22a, 2, 35.0, 21.675)).
cnf(b341, axiom, landmark(d2_22b, 2, 37.075, 24.75)).
cnf(b342, axiom, landmark(d2_23, 2, 42.6, 21.675)).
cnf(b343, axiom, landmark(i2_01, 2, 1.4, 5.35)).
cnf(b344, axiom, landmark(i2_02, 2, 8.95, 5.35)).
cnf(b345, axiom, landmark(i2_03, 2, 13.85, 5.35)).
cnf(b346, axiom, landmark(i2_04, 2, 19.0, 5.35)).
cnf(b347, axiom, landmark(i2_05, 2, 21.6, 5.35)).
cnf(b348, axiom, landmark(i2_06, 2, 29.65, 5.35)).
cnf(b349, axiom, landmark(i2_07, 2, 32.05, 5.35)).
cnf(b350, axiom, landmark(i2_08, 2, 42.6, 5.35)).
cnf(b351, axiom, landmark(i2_09, 2, 1.4, 9.65)).
cnf(b352, axiom, landmark(i2_09a, 2, 4.0, 11.15)).
cnf(b353, axiom, landmark(i2_10, 2, 8.95, 9.65)).
cnf(b354, axiom, landmark(i2_10a, 2, 5.95, 11.15)).
cnf(b355, axiom, landmark(i2_11, 2, 13.85, 9.65)).
cnf(b356, axiom, landmark(i2_12, 2, 29.65, 9.65)).
cnf(b357, axiom, landmark(i2_13, 2, 34.45, 9.65)).
cnf(b358, axiom, landmark(i2_14, 2, 42.6, 9.65)).
cnf(b359, axiom, landmark(i2_15, 2, 1.4, 18.25)).
cnf(b360, axiom, landmark(i2_16, 2, 15.45, 18.25)).
cnf(b361, axiom, landmark(i2_16a, 2, 13.55, 16.45)).
cnf(b362, axiom, landmark(i2_17, 2, 25.35, 18.25)).
cnf(b363, axiom, landmark(i2_18, 2, 42.6, 18.25)).
cnf(b364, axiom, landmark(i2_19, 2, 1.4, 22.65)).
cnf(b365, axiom, landmark(i2_20, 2, 11.4, 22.65)).
cnf(b366, axiom, landmark(i2_21, 2, 15.45, 22.65)).
cnf(b367, axiom, landmark(i2_21a, 2, 18.1, 24.75)).
cnf(b368, axiom, landmark(i2_22, 2, 21.15, 22.65)).
cnf(b369, axiom, landmark(i2_22a, 2, 35.0, 22.65)).
cnf(b370, axiom, landmark(i2_22b, 2, 36.1, 24.75)).
cnf(b371, axiom, landmark(i2_22c, 2, 20.05, 24.75)).
cnf(b372, axiom, landmark(i2_23, 2, 42.6, 22.65)).
cnf(b373, axiom, landmark(i2_23a, 2, 38.05, 24.75)).
cnf(b374, axiom, landmark(l2_e1, 2, 20.1, 12.5)).
cnf(b375, axiom, landmark(l2_e2, 2, 20.1, 15.5)).
cnf(b376, axiom, landmark(l2_mid, 2, 21.6, 14.0)).
cnf(b377, axiom, landmark(l2_n, 2, 21.6, 20.45)).
cnf(b378, axiom, landmark(l2_s, 2, 21.6, 7.5)).
cnf(b379, axiom, landmark(r2_01, 2, 3.1, 3.23)).
cnf(b380, axiom, landmark(r2_02, 2, 8.47, 3.23)).
cnf(b381, axiom, landmark(r2_03, 2, 13.23, 3.23)).
cnf(b382, axiom, landmark(r2_04, 2, 17.93, 3.23)).
cnf(b383, axiom, landmark(r2_05, 2, 23.48, 3.96)).
cnf(b384, axiom, landmark(r2_06, 2, 28.58, 3.23)).
cnf(b385, axiom, landmark(r2_07, 2, 33.83, 3.23)).
cnf(b386, axiom, landmark(r2_08, 2, 40.23, 3.23)).
cnf(b387, axiom, landmark(r2_09, 2, 2.55, 11.18)).
cnf(b388, axiom, landmark(r2_10, 2, 7.6, 11.18)).
cnf(b389, axiom, landmark(r2_11, 2, 14.65, 11.18)).
cnf(b390, axiom, landmark(r2_12, 2, 27.19, 10.44)).
cnf(b391, axiom, landmark(r2_13, 2, 35.75, 11.18)).
cnf(b392, axiom, landmark(r2_14, 2, 41.1, 11.18)).
cnf(b393, axiom, landmark(r2_15, 2, 5.48, 17.19)).
cnf(b394, axiom, landmark(r2_16, 2, 14.65, 16.45)).
cnf(b395, axiom, landmark(r2_17, 2, 27.5, 16.45)).
cnf(b396, axiom, landmark(r2_18, 2, 38.53, 16.45)).
cnf(b397, axiom, landmark(r2_19, 2, 2.85, 24.78)).
cnf(b398, axiom, landmark(r2_20, 2, 8.77, 24.04)).
cnf(b399, axiom, landmark(r2_21, 2, 15.83, 24.78)).
cnf(b400, axiom, landmark(r2_22, 2, 28.08, 24.78)).
cnf(b401, axiom, landmark(r2_23, 2, 40.48, 24.78)).
cnf(b402, axiom, landmark(x2_n1, 2, 11.4, 20.45)).
cnf(b403, axiom, landmark(x2_n2, 2, 32.05, 20.45)).
cnf(b404, axiom, landmark(x2_s1, 2, 11.4, 7.5)).
cnf(b405, axiom, landmark(x2_s2, 2, 32.05, 7.5)).
cnf(b406, axiom, door(d2_09, 2, 0.9, 8.675, 1.9, 8.675)).
cnf(b407, axiom, door(d2_10, 2, 8.45, 8.675, 9.45, 8.675)).
cnf(b408, axiom, door(d2_11, 2, 13.35, 8.675, 14.35, 8.675)).
cnf(b409, axiom, door(d2_12, 2, 29.15, 8.675, 30.15, 8.675)).
cnf(b410, axiom, door(d2_13, 2, 33.95, 8.675, 34.95, 8.675)).
cnf(b411, axiom, door(d2_14, 2, 42.1, 8.675, 43.1, 8.675)).
cnf(b412, axiom, door(d2_15, 2, 0.9, 19.225, 1.9, 19.225)).
cnf(b413, axiom, door(d2_16, 2, 14.95, 19.225, 15.95, 19.225)).
cnf(b414, axiom, door(d2_17, 2, 24.85, 19.225, 25.85, 19.225)).
cnf(b415, axiom, door(d2_18, 2, 42.1, 19.225, 43.1, 19.225)).
cnf(b416, axiom, door(d2_01, 2, 0.9, 6.325, 1.9, 6.325)).
cnf(b417, axiom, door(d2_02, 2, 8.45, 6.325, 9.45, 6.325)).
cnf(b418, axiom, door(d2_03, 2, 13.35, 6.325, 14.35, 6.325)).
cnf(b419, axiom, door(d2_04, 2, 18.5, 6.325, 19.5, 6.325)).
cnf(b420, axiom, door(d2_05, 2, 21.1, 6.325, 22.1, 6.325)).
cnf(b421, axiom, door(d2_06, 2, 29.15, 6.325, 30.15, 6.325)).
cnf(b422, axiom, door(d2_07, 2, 31.55, 6.325, 32.55, 6.325)).
cnf(b423, axiom, door(d2_08, 2, 42.1, 6.325, 43.1, 6.325)).
cnf(b424, axiom, door(d2_19, 2, 0.9, 21.675, 1.9, 21.675)).
cnf(b425, axiom, door(d2_20, 2, 10.9, 21.675, 11.9, 21.675)).
cnf(b426, axiom, door(d2_21, 2, 14.95, 21.675, 15.95, 21.675)).
cnf(b427, axiom, door(d2_22, 2, 20.65, 21.675, 21.65, 21.675)).
cnf(b428, axiom, door(d2_22a, 2, 34.5, 21.675, 35.5, 21.675)).
cnf(b429, axiom, door(d2_23, 2, 42.1, 21.675, 43.1, 21.675)).
cnf(b430, axiom, door(d2_09a, 2, 4.975, 10.65, 4.975, 11.65)).
cnf(b431, axiom, door(d2_22b, 2, 37.075, 24.25, 37.075, 25.25)).
cnf(b432, axiom, door(d2_16a, 2, 12.575, 15.95, 12.575, 16.95)).
cnf(b433, axiom, door(d2_21a, 2, 19.075, 24.25, 19.075, 25.25)).
cnf(b434, axiom, adjacent(c2_04, c2_11)).
cnf(b435, axiom, adjacent(c2_04, d2_04)).
cnf(b436, axiom, adjacent(c2_04, l2_s)).
cnf(b437, axiom, adjacent(c2_09, c2_10)).
cnf(b438, axiom, adjacent(c2_09, d2_01)).
cnf(b439, axiom, adjacent(c2_09, d2_09)).
cnf(b440, axiom, adjacent(c2_10, d2_02)).
cnf(b441, axiom, adjacent(c2_10, d2_10)).
cnf(b442, axiom, adjacent(c2_10, x2_s1)).
cnf(b443, axiom, adjacent(c2_11, d2_03)).
cnf(b444, axiom, adjacent(c2_11, d2_11)).
cnf(b445, axiom, adjacent(c2_11, x2_s1)).
cnf(b446, axiom, adjacent(c2_12, d2_06)).
cnf(b447, axiom, adjacent(c2_12, d2_12)).
cnf(b448, axiom, adjacent(c2_12, l2_s)).
cnf(b449, axiom, adjacent(c2_12, x2_s2)).
cnf(b450, axiom, adjacent(c2_13, c2_14)).
cnf(b451, axiom, adjacent(c2_13, d2_13)).
cnf(b452, axiom, adjacent(c2_13, x2_s2)).
cnf(b453, axiom, adjacent(c2_14, d2_08)).
cnf(b454, axiom, adjacent(c2_14, d2_14)).
cnf(b455, axiom, adjacent(c2_15, d2_15)).
cnf(b456, axiom, adjacent(c2_15, d2_19)).
cnf(b457, axiom, adjacent(c2_15, x2_n1)).
cnf(b458, axiom, adjacent(c2_16, c2_22)).
cnf(b459, axiom, adjacent(c2_16, d2_16)).
cnf(b460, axiom, adjacent(c2_16, d2_21)).
cnf(b461, axiom, adjacent(c2_16, x2_n1)).
cnf(b462, axiom, adjacent(c2_16a, d2_16a)).
cnf(b463, axiom, adjacent(c2_16a, x2_n1)).
cnf(b464, axiom, adjacent(c2_16a, x2_s1)).
cnf(b465, axiom, adjacent(c2_17, d2_17)).
cnf(b466, axiom, adjacent(c2_17, l2_n)).
cnf(b467, axiom, adjacent(c2_17, x2_n2)).
cnf(b468, axiom, adjacent(c2_18, c2_22a)).
cnf(b469, axiom, adjacent(c2_18, d2_18)).
cnf(b470, axiom, adjacent(c2_18, d2_23)).
cnf(b471, axiom, adjacent(c2_22, d2_22)).
cnf(b472, axiom, adjacent(c2_22, l2_n)).
cnf(b473, axiom, adjacent(c2_22a, d2_22a)).
cnf(b474, axiom, adjacent(c2_22a, x2_n2)).
cnf(b475, axiom, adjacent(d2_01, i2_01)).
cnf(b476, axiom, adjacent(d2_02, i2_02)).
cnf(b477, axiom, adjacent(d2_03, i2_03)).
cnf(b478, axiom, adjacent(d2_04, i2_04)).
cnf(b479, axiom, adjacent(d2_05, i2_05)).
cnf(b480, axiom, adjacent(d2_05, l2_s)).
cnf(b481, axiom, adjacent(d2_06, i2_06)).
cnf(b482, axiom, adjacent(d2_07, i2_07)).
cnf(b483, axiom, adjacent(d2_07, x2_s2)).
cnf(b484, axiom, adjacent(d2_08, i2_08)).
cnf(b485, axiom, adjacent(d2_09, i2_09)).
cnf(b486, axiom, adjacent(d2_09a, i2_09a)).
cnf(b487, axiom, adjacent(d2_09a, i2_10a)).
cnf(b488, axiom, adjacent(d2_10, i2_10)).
cnf(b489, axiom, adjacent(d2_11, i2_11)).
cnf(b490, axiom, adjacent(d2_12, i2_12)).
cnf(b491, axiom, adjacent(d2_13, i2_13)).
cnf(b492, axiom, adjacent(d2_14, i2_14)).
cnf(b493, axiom, adjacent(d2_15, i2_15)).
cnf(b494, axiom, adjacent(d2_16, i2_16)).
cnf(b495, axiom, adjacent(d2_16a, i2_16a)).
cnf(b496, axiom, adjacent(d2_17, i2_17)).
cnf(b497, axiom, adjacent(d2_18, i2_18)).
cnf(b498, axiom, adjacent(d2_19, i2_19)).
cnf(b499, axiom, adjacent(d2_20, i2_20)).
cnf(b500, axiom, adjacent(d2_20, x2_n1)).
cnf(b501, axiom, adjacent(d2_21, i2_21)).
cnf(b502, axiom, adjacent(d2_21a, i2_21a)).
cnf(b503, axiom, adjacent(d2_21a, i2_22c)).
cnf(b504, axiom, adjacent(d2_22, i2_22)).
cnf(b505, axiom, adjacent(d2_22a, i2_22a)).
cnf(b506, axiom, adjacent(d2_22b, i2_22b)).
cnf(b507, axiom, adjacent(d2_22b, i2_23a)).
cnf(b508, axiom, adjacent(d2_23, i2_23)).
cnf(b509, axiom, adjacent(i2_01, r2_01)).
cnf(b510, axiom, adjacent(i2_02, r2_02)).
cnf(b511, axiom, adjacent(i2_03, r2_03)).
cnf(b512, axiom, adjacent(i2_04, r2_04)).
cnf(b513, axiom, adjacent(i2_05, r2_05)).
cnf(b514, axiom, adjacent(i2_06, r2_06)).
cnf(b515, axiom, adjacent(i2_07, r2_07)).
cnf(b516, axiom, adjacent(i2_08, r2_08)).
cnf(b517, axiom, adjacent(i2_09, r2_09)).
cnf(b518, axiom, adjacent(i2_09a, r2_09)).
cnf(b519, axiom, adjacent(i2_10, r2_10)).
cnf(b520, axiom, adjacent(i2_10a, r2_10)).
cnf(b521, axiom, adjacent(i2_11, r2_11)).
cnf(b522, axiom, adjacent(i2_12, r2_12)).
cnf(b523, axiom, adjacent(i2_13, r2_13)).
cnf(b524, axiom, adjacent(i2_14, r2_14)).
cnf(b525, axiom, adjacent(i2_15, r2_15)).
cnf(b526, axiom, adjacent(i2_16, r2_16)).
cnf(b527, axiom, adjacent(i2_16a, r2_16)).
cnf(b528, axiom, adjacent(i2_17, r2_17)).
cnf(b529, axiom, adjacent(i2_18, r2_18)).
cnf(b530, axiom, adjacent(i2_19, r2_19)).
cnf(b531, axiom, adjacent(i2_20, r2_20)).
cnf(b532, axiom, adjacent(i2_21, r2_21)).
cnf(b533, axiom, adjacent(i2_21a, r2_21)).
cnf(b534, axiom, adjacent(i2_22, r2_22)).
cnf(b535, axiom, adjacent(i2_22a, r2_22)).
cnf(b536, axiom, adjacent(i2_22b, r2_22)).
cnf(b537, axiom, adjacent(i2_22c, r2_22)).
cnf(b538, axiom, adjacent(i2_23, r2_23)).
cnf(b539, axiom, adjacent(i2_23a, r2_23)).
cnf(b540, axiom, adjacent(l2_e1, l2_mid)).
cnf(b541, axiom, adjacent(l2_e2, l2_mid)).
cnf(b542, axiom, adjacent(l2_mid, l2_n)).
cnf(b543, axiom, adjacent(l2_mid, l2_s)).
cnf(b544, axiom, adjacent(x2_n2, x2_s2)).
cnf(b545, axiom, lobby(e1, l2_e1, 2)).
cnf(b546, axiom, lobby(e2, l2_e2, 2)).
cnf(b547, axiom, floor(3, 'floor3.png', 0.05)).
cnf(b548, axiom, room(r3_01, 3, 0.2, 0.2, 15.0, 7.15)).
cnf(b549, axiom, room(r3_02, 3, 15.15, 0.2, 21.0, 7.15)).
cnf(b550, axiom, room(r3_03, 3, 21.15, 0.2, 26.0, 7.15)).
cnf(b551, axiom, room(r3_04, 3, 26.15, 0.2, 31.0, 7.15)).
cnf(b552, axiom, room(r3_05, 3, 31.15, 0.2, 36.6, 7.15)).
cnf(b553, axiom, room(r3_06, 3, 36.75, 0.2, 43.8, 7.15)).
cnf(b554, axiom, room(r3_07, 3, 7.15, 9.65, 11.8, 13.8)).
cnf(b555, axiom, room(r3_08, 3, 11.95, 9.65, 16.65, 13.8)).
cnf(b556, axiom, room(r3_09, 3, 24.15, 9.65, 27.25, 13.8)).
cnf(b557, axiom, room(r3_10, 3, 29.75, 9.65, 33.75, 13.8)).
cnf(b558, axiom, room(r3_11, 3, 33.9, 9.65, 37.85, 13.8)).
cnf(b559, axiom, room(r3_12, 3, 38.0, 9.65, 43.8, 13.8)).
cnf(b560, axiom, room(r3_13, 3, 0.2, 13.95, 4.75, 18.15)).
cnf(b561, axiom, room(r3_14, 3, 7.15, 13.95, 16.65, 18.15)).
cnf(b562, axiom, room(r3_15, 3, 24.15, 13.95, 27.25, 18.15)).
cnf(b563, axiom, room(r3_16, 3, 29.75, 13.95, 37.85, 18.15)).
cnf(b564, axiom, room(r3_17, 3, 38.0, 13.95, 43.8, 18.15)).
cnf(b565, axiom, room(r3_18, 3, 0.2, 20.75, 4.9, 27.8)).
cnf(b566, axiom, room(r3_19, 3, 5.05, 20.75, 10.0, 27.8)).
cnf(b567, axiom, room(r3_20, 3, 10.15, 20.75, 16.5, 27.8)).
cnf(b568, axiom, room(r3_21, 3, 16.65, 20.75, 21.5, 27.8)).
cnf(b569, axiom, room(r3_22, 3, 21.65, 20.75, 27.0, 27.8)).
cnf(b570, axiom, room(r3_23, 3, 27.15, 20.75, 34.5, 27.8)).
cnf(b571, axiom, room(r3_24, 3, 34.65, 20.75, 43.8, 27.8)).
cnf(b572, axiom, landmark(c3_01, 3, 2.2, 8.4)).
cnf(b573, axiom, landmark(c3_01a, 3, 13.0, 8.4)).
cnf(b574, axiom, landmark(c3_02, 3, 19.8, 8.4)).
cnf(b575, axiom, landmark(c3_03, 3, 22.35, 8.4)).
cnf(b576, axiom, landmark(c3_07, 3, 8.35, 8.4)).
cnf(b577, axiom, landmark(c3_08, 3, 15.45, 8.4)).
cnf(b578, axiom, landmark(c3_09, 3, 25.35, 8.4)).
cnf(b579, axiom, landmark(c3_10, 3, 32.55, 8.4)).
cnf(b580, axiom, landmark(c3_11, 3, 35.1, 8.4)).
cnf(b581, axiom, landmark(c3_12, 3, 42.6, 8.4)).
cnf(b582, axiom, landmark(c3_13, 3, 1.4, 19.45)).
cnf(b583, axiom, landmark(c3_13a, 3, 5.95, 16.05)).
cnf(b584, axiom, landmark(c3_14, 3, 15.45, 19.45)).
cnf(b585, axiom, landmark(c3_15, 3, 25.35, 19.45)).
cnf(b586, axiom, landmark(c3_16, 3, 36.65, 19.45)).
cnf(b587, axiom, landmark(c3_16a, 3, 28.5, 16.05)).
cnf(b588, axiom, landmark(c3_17, 3, 39.2, 19.45)).
cnf(b589, axiom, landmark(c3_21, 3, 17.85, 19.45)).
cnf(b590, axiom, landmark(d3_01, 3, 2.2, 7.225)).
cnf(b591, axiom, landmark(d3_01a, 3, 13.0, 7.225)).
cnf(b592, axiom, landmark(d3_02, 3, 19.8, 7.225)).
cnf(b593, axiom, landmark(d3_03, 3, 22.35, 7.225)).
cnf(b594, axiom, landmark(d3_04, 3, 28.5, 7.225)).
cnf(b595, axiom, landmark(d3_05, 3, 32.55, 7.225)).
cnf(b596, axiom, landmark(d3_05a, 3, 36.675, 3.65)).
cnf(b597, axiom, landmark(d3_06, 3, 42.6, 7.225)).
cnf(b598, axiom, landmark(d3_07, 3, 8.35, 9.575)).
cnf(b599, axiom, landmark(d3_08, 3, 15.45, 9.575)).
cnf(b600, axiom, landmark(d3_09, 3, 25.35, 9.575)).
cnf(b601, axiom, landmark(d3_10, 3, 32.55, 9.575)).
cnf(b602, axiom, landmark(d3_11, 3, 35.1, 9.575)).
cnf(b603, axiom, landmark(d3_12, 3, 42.6, 9.575)).
cnf(b604, axiom, landmark(d3_13, 3, 1.4, 18.225)).
cnf(b605, axiom, landmark(d3_13a, 3, 4.825, 16.05)).
cnf(b606, axiom, landmark(d3_14, 3, 15.45, 18.225)).
cnf(b607, axiom, landmark(d3_15, 3, 25.35, 18.225)).
cnf(b608, axiom, landmark(d3_16, 3, 36.65, 18.225)).
cnf(b609, axiom, landmark(d3_16a, 3, 29.675, 16.05)).
cnf(b610, axiom, landmark(d3_17, 3, 39.2, 18.225)).
cnf(b611, axiom, landmark(d3_18, 3, 1.4, 20.675)).
cnf(b612, axiom, landmark(d3_19, 3, 5.95, 20.675)).
cnf(b613, axiom, landmark(d3_20, 3, 15.45, 20.675)).
cnf(b614, axiom, landmark(d3_21, 3, 17.85, 20.675)).
cnf(b615, axiom, landmark(d3_22, 3, 25.35, 20.675)).
cnf(b616, axiom, landmark(d3_23, 3, 28.5, 20.675)).
cnf(b617, axiom, landmark(d3_24, 3, 36.65, 20.675)).
cnf(b618, axiom, landmark(i3_01, 3, 2.2, 6.25)).
cnf(b619, axiom, landmark(i3_01a, 3, 13.0, 6.25)).
cnf(b620, axiom, landmark(i3_02, 3, 19.8, 6.25)).
cnf(b621, axiom, landmark(i3_03, 3, 22.35, 6.25)).
cnf(b622, axiom, landmark(i3_04, 3, 28.5, 6.25)).
cnf(b623, axiom, landmark(i3_05, 3, 32.55, 6.25)).
cnf(b624, axiom, landmark(i3_05a, 3, 35.7, 3.65)).
cnf(b625, axiom, landmark(i3_06, 3, 42.6, 6.25)).
cnf(b626, axiom, landmark(i3_06a, 3, 37.65, 3.65)).
cnf(b627, axiom, landmark(i3_07, 3, 8.35, 10.55)).
cnf(b628, axiom, landmark(i3_08, 3, 15.45, 10.55)).
cnf(b629, axiom, landmark(i3_09, 3, 25.35, 10.55)).
cnf(b630, axiom, landmark(i3_10, 3, 32.55, 10.55)).
cnf(b631, axiom, landmark(i3_11, 3, 35.1, 10.55)).
cnf(b632, axiom, landmark(i3_12, 3, 42.6, 10.55)).
cnf(b633, axiom, landmark(i3_13, 3, 1.4, 17.25)).
cnf(b634, axiom, landmark(i3_13a, 3, 3.85, 16.05)).
cnf(b635, axiom, landmark(i3_14, 3, 15.45, 17.25)).
cnf(b636, axiom, landmark(i3_15, 3, 25.35, 17.25)).
cnf(b637, axiom, landmark(i3_16, 3, 36.65, 17.25)).
cnf(b638, axiom, landmark(i3_16a, 3, 30.65, 16.05)).
cnf(b639, axiom, landmark(i3_17, 3, 39.2, 17.25)).
cnf(b640, axiom, landmark(i3_18, 3, 1.4, 21.65)).
cnf(b641, axiom, landmark(i3_19, 3, 5.95, 21.65)).
cnf(b642, axiom, landmark(i3_20, 3, 15.45, 21.65)).
cnf(b643, axiom, landmark(i3_21, 3, 17.85, 21.65)).
cnf(b644, axiom, landmark(i3_22, 3, 25.35, 21.65)).
cnf(b645, axiom, landmark(i3_23, 3, 28.5, 21.65)).
cnf(b646, axiom, landmark(i3_24, 3, 36.65, 21.65)).
cnf(b647, axiom, landmark(l3_e1, 3, 20.1, 12.5)).
cnf(b648, axiom, landmark(l3_e2, 3, 20.1, 15.5)).
cnf(b649, axiom, landmark(l3_mid, 3, 21.6, 14.0)).
cnf(b650, axiom, landmark(l3_n, 3, 21.6, 19.45)).
cnf(b651, axiom, landmark(l3_s, 3, 21.6, 8.4)).
cnf(b652, axiom, landmark(r3_01, 3, 7.6, 3.68)).
cnf(b653, axiom, landmark(r3_02, 3, 18.38, 4.41)).
cnf(b654, axiom, landmark(r3_03, 3, 23.58, 3.68)).
cnf(b655, axiom, landmark(r3_04, 3, 28.58, 3.68)).
cnf(b656, axiom, landmark(r3_05, 3, 33.88, 3.68)).
cnf(b657, axiom, landmark(r3_06, 3, 40.28, 3.68)).
cnf(b658, axiom, landmark(r3_07, 3, 9.47, 11.73)).
cnf(b659, axiom, landmark(r3_08, 3, 14.3, 11.73)).
cnf(b660, axiom, landmark(r3_09, 3, 25.7, 11.73)).
cnf(b661, axiom, landmark(r3_10, 3, 31.75, 11.73)).
cnf(b662, axiom, landmark(r3_11, 3, 35.88, 11.73)).
cnf(b663, axiom, landmark(r3_12, 3, 40.9, 11.73)).
cnf(b664, axiom, landmark(r3_13, 3, 2.48, 16.05)).
cnf(b665, axiom, landmark(r3_14, 3, 11.9, 16.05)).
cnf(b666, axiom, landmark(r3_15, 3, 25.7, 16.05)).
cnf(b667, axiom, landmark(r3_16, 3, 32.18, 17.23)).
cnf(b668, axiom, landmark(r3_17, 3, 40.9, 16.05)).
cnf(b669, axiom, landmark(r3_18, 3, 2.55, 24.28)).
cnf(b670, axiom, landmark(r3_19, 3, 7.53, 24.28)).
cnf(b671, axiom, landmark(r3_20, 3, 13.02, 23.54)).
cnf(b672, axiom, landmark(r3_21, 3, 19.07, 24.28)).
cnf(b673, axiom, landmark(r3_22, 3, 24.33, 24.28)).
cnf(b674, axiom, landmark(r3_23, 3, 30.83, 24.28)).
cnf(b675, axiom, landmark(r3_24, 3, 38.92, 23.54)).
cnf(b676, axiom, landmark(x3_n1, 3, 5.95, 19.45)).
cnf(b677, axiom, landmark(x3_n2, 3, 28.5, 19.45)).
cnf(b678, axiom, landmark(x3_s1, 3, 5.95, 8.4)).
cnf(b679, axiom, landmark(x3_s2, 3, 28.5, 8.4)).
cnf(b680, axiom, door(d3_07, 3, 7.85, 9.575, 8.85, 9.575)).
cnf(b681, axiom, door(d3_08, 3, 14.95, 9.575, 15.95, 9.575)).
cnf(b682, axiom, door(d3_09, 3, 24.85, 9.575, 25.85, 9.575)).
cnf(b683, axiom, door(d3_10, 3, 32.05, 9.575, 33.05, 9.575)).
cnf(b684, axiom, door(d3_11, 3, 34.6, 9.575, 35.6, 9.575)).
cnf(b685, axiom, door(d3_12, 3, 42.1, 9.575, 43.1, 9.575)).
cnf(b686, axiom, door(d3_13, 3, 0.9, 18.225, 1.9, 18.225)).
cnf(b687, axiom, door(d3_14, 3, 14.95, 18.225, 15.95, 18.225)).
cnf(b688, axiom, door(d3_15, 3, 24.85, 18.225, 25.85, 18.225)).
cnf(b689, axiom, door(d3_16, 3, 36.15, 18.225, 37.15, 18.225)).
cnf(b690, axiom, door(d3_17, 3, 38.7, 18.225, 39.7, 18.225)).
cnf(b691, axiom, door(d3_01, 3, 1.7, 7.225, 2.7, 7.225)).
cnf(b692, axiom, door(d3_01a, 3, 12.5, 7.225, 13.5, 7.225)).
cnf(b693, axiom, door(d3_02, 3, 19.3, 7.225, 20.3, 7.225)).
cnf(b694, axiom, door(d3_03, 3, 21.85, 7.225, 22.85, 7.225)).
cnf(b695, axiom, door(d3_04, 3, 28.0, 7.225, 29.0, 7.225)).
cnf(b696, axiom, door(d3_05, 3, 32.05, 7.225, 33.05, 7.225)).
cnf(b697, axiom, door(d3_06, 3, 42.1, 7.225, 43.1, 7.225)).
cnf(b698, axiom, door(d3_18, 3, 0.9, 20.675, 1.9, 20.675)).
cnf(b699, axiom, door(d3_19, 3, 5.45, 20.675, 6.45, 20.675)).
cnf(b700, axiom, door(d3_20, 3, 14.95, 20.675, 15.95, 20.675)).
cnf(b701, axiom, door(d3_21, 3, 17.35, 20.675, 18.35, 20.675)).
cnf(b702, axiom, door(d3_22, 3, 24.85, 20.675, 25.85, 20.675)).
cnf(b703, axiom, door(d3_23, 3, 28.0, 20.675, 29.0, 20.675)).
cnf(b704, axiom, door(d3_24, 3, 36.15, 20.675, 37.15, 20.675)).
cnf(b705, axiom, door(d3_05a, 3, 36.675, 3.15, 36.675, 4.15)).
cnf(b706, axiom, door(d3_16a, 3, 29.675, 15.55, 29.675, 16.55)).
cnf(b707, axiom, door(d3_13a, 3, 4.825, 15.55, 4.825, 16.55)).
cnf(b708, axiom, adjacent(c3_01, d3_01)).
cnf(b709, axiom, adjacent(c3_01, x3_s1)).
cnf(b710, axiom, adjacent(c3_01a, c3_07)).
cnf(b711, axiom, adjacent(c3_01a, c3_08)).
cnf(b712, axiom, adjacent(c3_01a, d3_01a)).
cnf(b713, axiom, adjacent(c3_02, c3_08)).
cnf(b714, axiom, adjacent(c3_02, d3_02)).
cnf(b715, axiom, adjacent(c3_02, l3_s)).
cnf(b716, axiom, adjacent(c3_03, c3_09)).
cnf(b717, axiom, adjacent(c3_03, d3_03)).
cnf(b718, axiom, adjacent(c3_03, l3_s)).
cnf(b719, axiom, adjacent(c3_07, d3_07)).
cnf(b720, axiom, adjacent(c3_07, x3_s1)).
cnf(b721, axiom, adjacent(c3_08, d3_08)).
cnf(b722, axiom, adjacent(c3_09, d3_09)).
cnf(b723, axiom, adjacent(c3_09, x3_s2)).
cnf(b724, axiom, adjacent(c3_10, c3_11)).
cnf(b725, axiom, adjacent(c3_10, d3_05)).
cnf(b726, axiom, adjacent(c3_10, d3_10)).
cnf(b727, axiom, adjacent(c3_10, x3_s2)).
cnf(b728, axiom, adjacent(c3_11, c3_12)).
cnf(b729, axiom, adjacent(c3_11, d3_11)).
cnf(b730, axiom, adjacent(c3_12, d3_06)).
cnf(b731, axiom, adjacent(c3_12, d3_12)).
cnf(b732, axiom, adjacent(c3_13, d3_13)).
cnf(b733, axiom, adjacent(c3_13, d3_18)).
cnf(b734, axiom, adjacent(c3_13, x3_n1)).
cnf(b735, axiom, adjacent(c3_13a, d3_13a)).
cnf(b736, axiom, adjacent(c3_13a, x3_n1)).
cnf(b737, axiom, adjacent(c3_13a, x3_s1)).
cnf(b738, axiom, adjacent(c3_14, c3_21)).
cnf(b739, axiom, adjacent(c3_14, d3_14)).
cnf(b740, axiom, adjacent(c3_14, d3_20)).
cnf(b741, axiom, adjacent(c3_14, x3_n1)).
cnf(b742, axiom, adjacent(c3_15, d3_15)).
cnf(b743, axiom, adjacent(c3_15, d3_22)).
cnf(b744, axiom, adjacent(c3_15, l3_n)).
cnf(b745, axiom, adjacent(c3_15, x3_n2)).
cnf(b746, axiom, adjacent(c3_16, c3_17)).
cnf(b747, axiom, adjacent(c3_16, d3_16)).
cnf(b748, axiom, adjacent(c3_16, d3_24)).
cnf(b749, axiom, adjacent(c3_16, x3_n2)).
cnf(b750, axiom, adjacent(c3_16a, d3_16a)).
cnf(b751, axiom, adjacent(c3_16a, x3_n2)).
cnf(b752, axiom, adjacent(c3_16a, x3_s2)).
cnf(b753, axiom, adjacent(c3_17, d3_17)).
cnf(b754, axiom, adjacent(c3_21, d3_21)).
cnf(b755, axiom, adjacent(c3_21, l3_n)).
cnf(b756, axiom, adjacent(d3_01, i3_01)).
cnf(b757, axiom, adjacent(d3_01a, i3_01a)).
cnf(b758, axiom, adjacent(d3_02, i3_02)).
cnf(b759, axiom, adjacent(d3_03, i3_03)).
cnf(b760, axiom, adjacent(d3_04, i3_04)).
cnf(b761, axiom, adjacent(d3_04, x3_s2)).
cnf(b762, axiom, adjacent(d3_05, i3_05)).
cnf(b763, axiom, adjacent(d3_05a, i3_05a)).
cnf(b764, axiom, adjacent(d3_05a, i3_06a)).
cnf(b765, axiom, adjacent(d3_06, i3_06)).
cnf(b766, axiom, adjacent(d3_07, i3_07)).
cnf(b767, axiom, adjacent(d3_08, i3_08)).
cnf(b768, axiom, adjacent(d3_09, i3_09)).
cnf(b769, axiom, adjacent(d3_10, i3_10)).
cnf(b770, axiom, adjacent(d3_11, i3_11)).
cnf(b771, axiom, adjacent(d3_12, i3_12)).
cnf(b772, axiom, adjacent(d3_13, i3_13)).
cnf(b773, axiom, adjacent(d3_13a, i3_13a)).
cnf(b774, axiom, adjacent(d3_14, i3_14)).
cnf(b775, axiom, adjacent(d3_15, i3_15)).
cnf(b776, axiom, adjacent(d3_16, i3_16)).
cnf(b777, axiom, adjacent(d3_16a, i3_16a)).
cnf(b778, axiom, adjacent(d3_17, i3_17)).
cnf(b779, axiom, adjacent(d3_18, i3_18)).
cnf(b780, axiom, adjacent(d3_19, i3_19)).
cnf(b781, axiom, adjacent(d3_19, x3_n1)).
cnf(b782, axiom, adjacent(d3_20, i3_20)).
cnf(b783, axiom, adjacent(d3_21, i3_21)).
cnf(b784, axiom, adjacent(d3_22, i3_22)).
cnf(b785, axiom, adjacent(d3_23, i3_23)).
cnf(b786, axiom, adjacent(d3_23, x3_n2)).
cnf(b787, axiom, adjacent(d3_24, i3_24)).
cnf(b788, axiom, adjacent(i3_01, r3_01)).
cnf(b789, axiom, adjacent(i3_01a, r3_01)).
cnf(b790, axiom, adjacent(i3_02, r3_02)).
cnf(b791, axiom, adjacent(i3_03, r3_03)).
cnf(b792, axiom, adjacent(i3_04, r3_04)).
cnf(b793, axiom, adjacent(i3_05, r3_05)).
cnf(b794, axiom, adjacent(i3_05a, r3_05)).
cnf(b795, axiom, adjacent(i3_06, r3_06)).
cnf(b796, axiom, adjacent(i3_06a, r3_06)).
cnf(b797, axiom, adjacent(i3_07, r3_07)).
cnf(b798, axiom, adjacent(i3_08, r3_08)).
cnf(b799, axiom, adjacent(i3_09, r3_09)).
cnf(b800, axiom, adjacent(i3_10, r3_10)).
cnf(b801, axiom, adjacent(i3_11, r3_11)).
cnf(b802, axiom, adjacent(i3_12, r3_12)).
cnf(b803, axiom, adjacent(i3_13, r3_13)).
cnf(b804, axiom, adjacent(i3_13a, r3_13)).
cnf(b805, axiom, adjacent(i3_14, r3_14)).
cnf(b806, axiom, adjacent(i3_15, r3_15)).
cnf(b807, axiom, adjacent(i3_16, r3_16)).
cnf(b808, axiom, adjacent(i3_16a, r3_16)).
cnf(b809, axiom, adjacent(i3_17, r3_17)).
cnf(b810, axiom, adjacent(i3_18, r3_18)).
cnf(b811, axiom, adjacent(i3_19, r3_19)).
cnf(b812, axiom, adjacent(i3_20, r3_20)).
cnf(b813, axiom, adjacent(i3_21, r3_21)).
cnf(b814, axiom, adjacent(i3_22, r3_22)).
cnf(b815, axiom, adjacent(i3_23, r3_23)).
cnf(b816, axiom, adjacent(i3_24, r3_24)).
cnf(b817, axiom, adjacent(l3_e1, l3_mid)).
cnf(b818, axiom, adjacent(l3_e2, l3_mid)).
cnf(b819, axiom, adjacent(l3_mid, l3_n)).
cnf(b820, axiom, adjacent(l3_mid, l3_s)).
cnf(b821, axiom, lobby(e1, l3_e1, 3)).
cnf(b822, axiom, lobby(e2, l3_e2, 3)).
cnf(b823, axiom, elevator(e1, 17.0, 11.5, 19.0, 13.5, 19.1, 11.95, 19.1, 13.05)).
cnf(b824, axiom, cab(e1, cab_e1)).
cnf(b825, axiom, landmark(cab_e1, 0, 18.0, 12.5)).
cnf(b826, axiom, elevator(e2, 17.0, 14.5, 19.0, 16.5, 19.1, 14.95, 19.1, 16.05)).
cnf(b827, axiom, cab(e2, cab_e2)).
cnf(b828, axiom, landmark(cab_e2, 0, 18.0, 15.5)).
