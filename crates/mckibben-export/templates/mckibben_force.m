function [force, stiffness, by_pressure, volume, status] = mckibben_force(pressure, length)
% MCKIBBEN_FORCE  Pull in N at pressures in Pa and lengths in m, numbers or arrays of one size.
%   [force, stiffness, by_pressure, volume, status] = mckibben_force(pressure, length)
%   stiffness: dF/dL in N/m; by_pressure: dF/dP in m2; volume in m3 (slack: at the free contraction);
%   status: 0, or a sum of 1 slack, 2 pressure outside of the box, 4 contraction outside.
% @{facts}
pressure = pressure + 0 * length;
length = length + 0 * pressure;
[~, ~, ~, muscle] = mckibben_coefficients(0);
e = 1 - length / muscle.length;
[c, slope, integral] = mckibben_coefficients(e);
q = pressure / muscle.supply;
[phi, dphi] = square(q);
pull = c{1} + c{2} .* q + c{3} .* phi;
slack = pull <= 0;
force = max(pull, 0);
stiffness = -(slope{1} + slope{2} .* q + slope{3} .* phi) / muscle.length .* ~slack;
by_pressure = (c{2} + c{3} .* dphi) / muscle.supply .* ~slack;
status = slack + 2 * (pressure < 0 | pressure > muscle.supply) + 4 * (e < muscle.low | e > muscle.high);
if nargout > 3
    if any(slack(:)) % it hangs at its free contraction: bisection, or the tangent outside of the box
        low = muscle.low + 0 * q; high = muscle.high + 0 * q;
        for k = 1:50
            middle = 0.5 * (low + high);
            cm = mckibben_coefficients(middle);
            over = cm{1} + cm{2} .* q + cm{3} .* phi > 0;
            low(over) = middle(over); high(~over) = middle(~over);
        end
        free = 0.5 * (low + high);
        for edge = [muscle.low, muscle.high]
            [ce, se] = mckibben_coefficients(edge + 0 * q);
            pull = ce{1} + ce{2} .* q + ce{3} .* phi;
            by_e = se{1} + se{2} .* q + se{3} .* phi;
            beyond = (edge == muscle.low & pull <= 0) | (edge == muscle.high & pull >= 0);
            falls = beyond & by_e < 0;
            free(beyond) = edge;
            free(falls) = edge - pull(falls) ./ by_e(falls);
        end
        e(slack) = free(slack);
        [~, ~, integral] = mckibben_coefficients(e);
    end
    volume = muscle.v(1) + muscle.v(2) * q + muscle.v(3) * phi + muscle.length / muscle.supply * (integral{2} + integral{3} .* dphi);
end
end

function [phi, dphi] = square(q)
phi = (q > 0 & q <= 1) .* q .^ 2 + (q > 1) .* (2 * q - 1);
dphi = (q > 0 & q <= 1) .* 2 .* q + 2 * (q > 1);
end
